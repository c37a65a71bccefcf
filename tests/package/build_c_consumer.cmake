# Installs the build tree BUILD to a folder of SCRATCH, which is overwritten, and builds and runs the C program PROGRAM
# with it: by a CMake project in C alone, and if there is PKG_CONFIG by the compiler and its flags.
#
# COMPILER (for C), GENERATOR and FLAGS (for the linker) are those of the build under test.
cmake_minimum_required(VERSION 3.22)

function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(NOT result EQUAL 0)
    message(NOTICE "${output}")
    message(FATAL_ERROR "failed (${result}): ${ARGN}")
  endif()
  set(output "${output}" PARENT_SCOPE)
endfunction()

file(REMOVE_RECURSE ${SCRATCH})
run(${CMAKE_COMMAND} --install ${BUILD} --prefix ${SCRATCH}/first)
file(RENAME ${SCRATCH}/first ${SCRATCH}/moved)
run(${CMAKE_COMMAND} -S ${CMAKE_CURRENT_LIST_DIR}/c_consumer -B ${SCRATCH}/build -G ${GENERATOR}
    -D CMAKE_C_COMPILER=${COMPILER} -D CMAKE_EXE_LINKER_FLAGS=${FLAGS} -D CMAKE_PREFIX_PATH=${SCRATCH}/moved
    -D CMAKE_FIND_USE_PACKAGE_REGISTRY=OFF -D PROGRAM=${PROGRAM})
run(${CMAKE_COMMAND} --build ${SCRATCH}/build)
run(${CMAKE_CTEST_COMMAND} --test-dir ${SCRATCH}/build --output-on-failure --no-tests=error)

if(PKG_CONFIG)
  file(GLOB_RECURSE pc ${SCRATCH}/moved/*/thalweg-c.pc)
  get_filename_component(folder ${pc} DIRECTORY)
  set(ENV{PKG_CONFIG_PATH} ${folder})
  set(ENV{LD_LIBRARY_PATH} ${folder}/..)
  run(${PKG_CONFIG} --cflags --libs thalweg-c)
  separate_arguments(flags UNIX_COMMAND "${output}")
  run(${COMPILER} -std=c11 ${PROGRAM} ${flags} ${FLAGS} -o ${SCRATCH}/uses_c)
  run(${SCRATCH}/uses_c)
endif()
