# The package that find_package(Terrane) and pkg-config find. Both are relocatable.
set(TERRANE_CMAKE_INSTALL_DIR ${CMAKE_INSTALL_LIBDIR}/cmake/Terrane)
set(TERRANE_PKGCONFIG_INSTALL_DIR ${CMAKE_INSTALL_LIBDIR}/pkgconfig)

configure_package_config_file(cmake/TerraneConfig.cmake.in ${CMAKE_BINARY_DIR}/package/TerraneConfig.cmake
  INSTALL_DESTINATION ${TERRANE_CMAKE_INSTALL_DIR})
write_basic_package_version_file(${CMAKE_BINARY_DIR}/package/TerraneConfigVersion.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_BINARY_DIR}/package/TerraneConfig.cmake ${CMAKE_BINARY_DIR}/package/TerraneConfigVersion.cmake
  DESTINATION ${TERRANE_CMAKE_INSTALL_DIR})
install(EXPORT TerraneTargets NAMESPACE Terrane:: DESTINATION ${TERRANE_CMAKE_INSTALL_DIR})

# terrane.pc for whole programs, terrane-generators.pc and terrane-patchdb.pc for those without Coin.
file(RELATIVE_PATH TERRANE_PKGCONFIG_TO_PREFIX /${TERRANE_PKGCONFIG_INSTALL_DIR} /)
function(terrane_pkgconfig name description requires libraries)
  set(PC_NAME ${name})
  set(PC_DESCRIPTION ${description})
  set(PC_REQUIRES ${requires})
  set(PC_LIBRARIES ${libraries})
  configure_file(cmake/terrane.pc.in ${CMAKE_BINARY_DIR}/package/${name}.pc @ONLY)
  install(FILES ${CMAKE_BINARY_DIR}/package/${name}.pc DESTINATION ${TERRANE_PKGCONFIG_INSTALL_DIR})
endfunction()
terrane_pkgconfig(terrane-generators "Height maps, terrain generators and filters" "glm" "-lTerraneGenerators")
terrane_pkgconfig(terrane-patchdb "Endless terrain in patches" "terrane-generators" "-lTerranePatchdb")
# Coin brings no pkg-config file in Debian.
terrane_pkgconfig(terrane "${PROJECT_DESCRIPTION}" "terrane-patchdb" "-lTerraneEngine -lTerraneNodes -lCoin")

install(FILES LICENSE README.md CHANGELOG.md DESTINATION ${CMAKE_INSTALL_DOCDIR})
