# Run by ctest: see CMakeLists.txt. Fails at the first command that fails.
function(run)
  execute_process(COMMAND ${ARGV} RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(NOT result EQUAL 0)
    string(REPLACE ";" " " command "${ARGV}")
    message(FATAL_ERROR "${command}\n${output}\nended with ${result}")
  endif()
  set(output "${output}" PARENT_SCOPE)
endfunction()

function(expect_same text)
  if(NOT output STREQUAL text)
    message(FATAL_ERROR "expected\n${text}\nbut got\n${output}")
  endif()
endfunction()

file(REMOVE_RECURSE ${SCRATCH})
# Installed in one place and moved to another: the package must not know where it was built.
run(${CMAKE_COMMAND} --install ${BUILD} --prefix ${SCRATCH}/first)
file(RENAME ${SCRATCH}/first ${SCRATCH}/prefix)
set(ENV{LD_LIBRARY_PATH})

run(${CMAKE_COMMAND} -S ${SOURCE}/consumer -B ${SCRATCH}/cmake -D CMAKE_PREFIX_PATH=${SCRATCH}/prefix
    -D CMAKE_CXX_COMPILER=${CXX} -D CMAKE_BUILD_TYPE=Release)
run(${CMAKE_COMMAND} --build ${SCRATCH}/cmake)
run(${SCRATCH}/cmake/heights)
set(heights "${output}")
run(${SCRATCH}/cmake/scene)
set(scene "${output}")
message(STATUS "find_package: ${heights}${scene}")

find_program(PKG_CONFIG NAMES pkg-config pkgconf REQUIRED)
set(ENV{PKG_CONFIG_PATH} ${SCRATCH}/prefix/${LIBDIR}/pkgconfig)
function(build_with_pkg_config package program)
  run(${PKG_CONFIG} --cflags --libs ${package})
  separate_arguments(flags UNIX_COMMAND "${output}")
  run(${CXX} -std=c++17 ${SOURCE}/consumer/${program}.cpp -o ${SCRATCH}/${program} ${flags}
      -Wl,-rpath,${SCRATCH}/prefix/${LIBDIR})
  run(${SCRATCH}/${program})
  set(output "${output}" PARENT_SCOPE)
endfunction()
build_with_pkg_config(terrane-patchdb heights)
expect_same("${heights}")
build_with_pkg_config(terrane scene)
expect_same("${scene}")
run(${PKG_CONFIG} --modversion terrane)
expect_same("${VERSION}\n")

unset(ENV{DISPLAY})
run(${SCRATCH}/prefix/bin/terrane-static --size 64x48 --quiet --offscreen ${SCRATCH}/picture.png
    --export ${SCRATCH}/scene.iv)
foreach(written picture.png scene.iv)
  if(NOT EXISTS ${SCRATCH}/${written})
    message(FATAL_ERROR "the installed terrane-static wrote no ${written}")
  endif()
endforeach()

run(${SCRATCH}/prefix/bin/terrane-bake synth ${SCRATCH}/terrain.raw --size 33 --quiet)
run(${SCRATCH}/prefix/bin/terrane-bake mipmaps ${SCRATCH}/terrain.raw ${SCRATCH}/terrain --quiet)
if(NOT EXISTS ${SCRATCH}/terrain_5.raw)
  message(FATAL_ERROR "the installed terrane-bake wrote no terrain_5.raw")
endif()

# A program that is linked with Coin only finds the installed node by its name in a file.
file(WRITE ${SCRATCH}/terrain.iv "#Inventor V2.1 ascii\nTeStaticTerrain { seed 7 }\n")
set(ENV{LD_LIBRARY_PATH} ${SCRATCH}/prefix/${LIBDIR})
run(${BUILD}/bin/readByName ${SCRATCH}/terrain.iv TeStaticTerrain ${SCRATCH}/terrain-again.iv)
expect_same("TeStaticTerrain: 17672 triangles\n")
