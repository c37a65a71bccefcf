# Configures, builds and runs tests/package/consumer the way a stranger would, in SCRATCH, which is overwritten.
#
#   MODE subdirectory: from the checkout SOURCE; configuring must print nothing
#   MODE find_package: from the build tree BUILD installed to a prefix, which is then moved
#   MODE pkg_config:   the same, with the compiler and pkg-config alone
#
# COMPILER, LAUNCHER, GENERATOR and FLAGS (for the linker) are those of the build under test.
cmake_minimum_required(VERSION 3.22)
set(consumer ${CMAKE_CURRENT_LIST_DIR}/consumer)

function(run out)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(NOT result EQUAL 0)
    message(NOTICE "${output}")
    message(FATAL_ERROR "failed (${result}): ${ARGN}")
  endif()
  set(${out} "${output}" PARENT_SCOPE)
endfunction()

# Installs, and moves what was installed: nothing in it may remember where it was.
function(install_elsewhere)
  run(ignored ${CMAKE_COMMAND} --install ${BUILD} --prefix ${SCRATCH}/first)
  file(RENAME ${SCRATCH}/first ${SCRATCH}/moved)
endfunction()

function(build_with_cmake)
  run(said ${CMAKE_COMMAND} -S ${consumer} -B ${SCRATCH}/build -G ${GENERATOR} -D CMAKE_BUILD_TYPE=Debug
           -D CMAKE_CXX_COMPILER=${COMPILER} -D CMAKE_CXX_COMPILER_LAUNCHER=${LAUNCHER}
           -D CMAKE_EXE_LINKER_FLAGS=${FLAGS} -D CMAKE_FIND_USE_PACKAGE_REGISTRY=OFF ${ARGN})
  if(MODE STREQUAL subdirectory AND NOT said MATCHES "thalweg begins\n-- consumer: thalweg ends")
    message(FATAL_ERROR "embedding thalweg prints something:\n${said}")
  endif()
  run(ignored ${CMAKE_COMMAND} --build ${SCRATCH}/build --parallel 2)
  run(ignored ${CMAKE_CTEST_COMMAND} --test-dir ${SCRATCH}/build --output-on-failure --no-tests=error)
endfunction()

file(REMOVE_RECURSE ${SCRATCH})
file(MAKE_DIRECTORY ${SCRATCH})
if(MODE STREQUAL subdirectory)
  build_with_cmake(-D THALWEG_SOURCE=${SOURCE})
elseif(MODE STREQUAL find_package)
  install_elsewhere()
  build_with_cmake(-D CMAKE_PREFIX_PATH=${SCRATCH}/moved)
else()
  install_elsewhere()
  file(GLOB_RECURSE pc ${SCRATCH}/moved/*/thalweg.pc)
  run(flags ${PKG_CONFIG} --cflags --libs ${pc})
  separate_arguments(flags UNIX_COMMAND "${flags}")
  run(ignored ${COMPILER} -std=c++20 ${consumer}/uses_thalweg.cpp ${flags} ${FLAGS} -o ${SCRATCH}/uses_thalweg)
  run(ignored ${SCRATCH}/uses_thalweg)
endif()
