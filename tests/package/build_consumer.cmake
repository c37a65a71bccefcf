# Configures, builds and runs tests/package/consumer the way a stranger would, in SCRATCH, which is overwritten.
#
#   MODE subdirectory, fetch_content: from the checkout SOURCE; configuring must print nothing and change nothing
#   MODE find_package: from the build tree BUILD installed to a prefix, which is then moved
#   MODE pkg_config:   the same, by the README's command
#
# SHARED: of a shared library. COMPILER, LAUNCHER, GENERATOR and FLAGS (for the linker) are those of the build under
# test, VERSION is what must be found. From its sources the library is compiled in few big units and without
# optimisation: that it compiles file by file is what the build under test has shown already.
cmake_minimum_required(VERSION 3.22)
include(${CMAKE_CURRENT_LIST_DIR}/steps.cmake)

# Installs, and moves what was installed: nothing in it may remember where it was.
function(install_elsewhere)
  run(ignored ${CMAKE_COMMAND} --install ${BUILD} --prefix ${SCRATCH}/first)
  file(RENAME ${SCRATCH}/first ${SCRATCH}/moved)
  file(GLOB_RECURSE installed RELATIVE ${SCRATCH}/moved/include ${SCRATCH}/moved/include/*)
  file(GLOB public RELATIVE ${SOURCE}/include ${SOURCE}/include/thalweg/*)
  expect("headers installed" "${installed}" "${public}")
endfunction()

# FLOORS of the library, for a consumer of which TARGET is built.
function(build_with_cmake floors target)
  file(COPY ${CMAKE_CURRENT_LIST_DIR}/consumer DESTINATION ${SCRATCH})
  run(said ${CMAKE_COMMAND} -S ${SCRATCH}/consumer -B ${SCRATCH}/build -G ${GENERATOR} -D TAKE=${MODE}
           -D FLOORS=${floors} -D VERSION=${VERSION} -D CMAKE_BUILD_TYPE= -D CMAKE_CXX_COMPILER=${COMPILER}
           -D CMAKE_CXX_COMPILER_LAUNCHER=${LAUNCHER} -D CMAKE_EXE_LINKER_FLAGS=${FLAGS}
           -D CMAKE_FIND_USE_PACKAGE_REGISTRY=OFF ${ARGN})
  if(NOT MODE STREQUAL find_package AND NOT said MATCHES "thalweg begins\n-- consumer: thalweg ends")
    message(FATAL_ERROR "embedding thalweg prints something:\n${said}")
  endif()
  run(ignored ${CMAKE_COMMAND} --build ${SCRATCH}/build --parallel 2 --target ${target})
  run(ignored ${CMAKE_CTEST_COMMAND} --test-dir ${SCRATCH}/build --output-on-failure --no-tests=error)
endfunction()

# The shared library shows our public names and nothing else.
function(check_exports library)
  run(table nm -D --defined-only --demangle ${library})
  string(REGEX MATCHALL "[^\n]+" lines "${table}")
  list(FILTER lines EXCLUDE REGEX " [TRVu] thalweg::")  # functions, and constants of classes
  string(REGEX MATCHALL "[^\n]*(detail|anonymous)[^\n]*" inner "${table}")
  list(FILTER inner EXCLUDE REGEX "detail::(de)?allocate_array")  # which the headers call
  expect("names that a shared library should hide" "${lines}${inner}" "")
  if(NOT table MATCHES "thalweg::minimize_pits")
    message(FATAL_ERROR "${library} does not show thalweg::minimize_pits:\n${table}")
  endif()
endfunction()

set(few_units -D CMAKE_UNITY_BUILD=ON -D CMAKE_UNITY_BUILD_BATCH_SIZE=0)
file(REMOVE_RECURSE ${SCRATCH})
file(MAKE_DIRECTORY ${SCRATCH})
if(MODE STREQUAL subdirectory)
  build_with_cmake(kernel,order consumer -D THALWEG_SOURCE=${SOURCE} ${few_units})
elseif(MODE STREQUAL fetch_content)
  build_with_cmake(thalweg all -D FETCHCONTENT_SOURCE_DIR_THALWEG=${SOURCE} -D BUILD_SHARED_LIBS=ON
                   -D THALWEG_INSTALL=ON ${few_units})
elseif(MODE STREQUAL find_package)
  install_elsewhere()
  build_with_cmake(kernel,order,thalweg consumer -D CMAKE_PREFIX_PATH=${SCRATCH}/moved)
  if(SHARED)
    file(GLOB_RECURSE library ${SCRATCH}/moved/*/libthalweg.so.*.*.*)
    check_exports(${library})
  endif()
else()
  install_elsewhere()
  file(GLOB_RECURSE pc ${SCRATCH}/moved/*/thalweg.pc)
  get_filename_component(folder ${pc} DIRECTORY)
  file(GLOB_RECURSE library ${SCRATCH}/moved/*/libthalweg.*)
  list(GET library 0 library)
  get_filename_component(library_folder ${library} DIRECTORY)
  set(ENV{PKG_CONFIG_PATH} ${folder})
  set(ENV{LD_LIBRARY_PATH} ${library_folder})
  run(version pkg-config --modversion thalweg)
  expect("version of pkg-config" "${version}" "${VERSION}\n")
  readme_command("pkg-config" command)
  file(COPY_FILE ${CMAKE_CURRENT_LIST_DIR}/consumer/uses_thalweg.cpp ${SCRATCH}/app.cpp)
  run_in(${SCRATCH} ignored sh -ec "${command} ${strict} ${FLAGS} && ./app ${VERSION}")
endif()
