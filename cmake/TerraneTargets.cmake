# How every target of the project is compiled and linked.

# Bit-equality over compilers rests on these: no contraction, no value-changing floating-point options.
add_library(terrane_options INTERFACE)
target_compile_options(terrane_options INTERFACE
  -ffp-contract=off -fno-fast-math -Wall -Wextra -Wpedantic)
target_include_directories(terrane_options INTERFACE ${CMAKE_SOURCE_DIR})
if(TERRANE_SANITIZE)
  add_compile_options(-fsanitize=${TERRANE_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all)
  add_link_options(-fsanitize=${TERRANE_SANITIZE})
endif()

# terrane_layer(generators): shared library libTerraneGenerators of all sources in this folder, exported as
# Terrane::generators.
function(terrane_layer layer)
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/*.cpp)
  list(FILTER sources EXCLUDE REGEX "/modules/")
  string(SUBSTRING ${layer} 0 1 first)
  string(TOUPPER ${first} first)
  string(SUBSTRING ${layer} 1 -1 rest)
  add_library(${layer} SHARED ${sources})
  add_library(Terrane::${layer} ALIAS ${layer})
  set_target_properties(${layer} PROPERTIES
    OUTPUT_NAME Terrane${first}${rest}
    VERSION ${PROJECT_VERSION} SOVERSION ${PROJECT_VERSION_MAJOR}
    INSTALL_RPATH "$ORIGIN")
  target_link_libraries(${layer} PRIVATE $<BUILD_INTERFACE:terrane_options>)
  target_compile_features(${layer} PUBLIC cxx_std_17)
  target_include_directories(${layer} PUBLIC
    $<BUILD_INTERFACE:${CMAKE_SOURCE_DIR}>
    $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/Terrane>)
  install(TARGETS ${layer} EXPORT TerraneTargets
    LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR})
  install(DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR}/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/Terrane/${layer}
    FILES_MATCHING PATTERN "*.h" PATTERN "modules" EXCLUDE)
endfunction()

# terrane_module(name sources...): a library that is loaded by name when first needed (TeModule.h).
function(terrane_module name)
  add_library(${name} MODULE ${ARGN})
  set_target_properties(${name} PROPERTIES
    LIBRARY_OUTPUT_DIRECTORY ${TERRANE_MODULE_OUTPUT_DIRECTORY} PREFIX "" INSTALL_RPATH "$ORIGIN/..")
  target_link_libraries(${name} PRIVATE $<BUILD_INTERFACE:terrane_options>)
  install(TARGETS ${name} LIBRARY DESTINATION ${TERRANE_MODULE_INSTALL_DIR})
endfunction()

# terrane_app(name sources...): an application whose OpenGL is chosen when it starts. bin/<name> is a launcher
# that links neither OpenGL nor Coin; it loads OSMesa first if --context asks for it, then app-<name>.so with
# the sources, which define `extern "C" int teMain(int argc, char** argv)`. Link libraries and options go to
# the target app-<name>. NO_INSTALL after the name keeps it in the build tree (tests).
function(terrane_app name)
  cmake_parse_arguments(APP "NO_INSTALL" "" "" ${ARGN})
  add_library(app-${name} MODULE ${APP_UNPARSED_ARGUMENTS})
  set_target_properties(app-${name} PROPERTIES
    LIBRARY_OUTPUT_DIRECTORY ${TERRANE_MODULE_OUTPUT_DIRECTORY} PREFIX "" INSTALL_RPATH "$ORIGIN/..")
  target_link_libraries(app-${name} PRIVATE terrane_options)
  add_executable(${name} ${CMAKE_SOURCE_DIR}/apps/common/launcher.cpp)
  target_compile_definitions(${name} PRIVATE TERRANE_APP="${name}" TERRANE_BIN_TO_LIB="${TERRANE_BIN_TO_LIB}")
  target_link_libraries(${name} PRIVATE terrane_options ${CMAKE_DL_LIBS})
  add_dependencies(${name} app-${name} context-egl context-osmesa osmesa-shim)
  if(TARGET context-window)
    add_dependencies(${name} context-window)
  endif()
  if(NOT APP_NO_INSTALL)
    install(TARGETS ${name} RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
    install(TARGETS app-${name} LIBRARY DESTINATION ${TERRANE_MODULE_INSTALL_DIR})
  endif()
endfunction()
