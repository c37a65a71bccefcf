# Flags that ask for fused multiply-adds do not get them, neither from the two files nor from the sources themselves:
# the pragmas forbid it. Without the pragmas they would: else this test could not fail. For x86-64, and the sources in
# which most of the arithmetic is. Under an explicit -ffp-contract=fast clang++ heeds no pragma, so it gets none.
cmake_minimum_required(VERSION 3.22)
include(${CMAKE_CURRENT_LIST_DIR}/steps.cmake)

set(flags -std=gnu++20 -O2 -mfma -S)
run(said ${COMPILER} --version)
if(NOT said MATCHES "clang")
  list(APPEND flags -ffp-contract=fast)
endif()

# The number of fused instructions that FILE is compiled to.
function(count_fused file out)
  run(ignored ${COMPILER} ${flags} -I${SOURCE}/include -I${SOURCE}/src ${file} -o ${SCRATCH}/out.s)
  file(STRINGS ${SCRATCH}/out.s fused REGEX "vfn?m(add|sub)[0-9]")
  list(LENGTH fused count)
  set(${out} ${count} PARENT_SCOPE)
endfunction()

file(REMOVE_RECURSE ${SCRATCH})
run(ignored ${CMAKE_COMMAND} -D ROOT=${SOURCE} -D OUTPUT=${SCRATCH} -D VERSION=${VERSION}
            -D SOURCES=kernel/predicates.cpp,kernel/predicates_exact.cpp -P ${SOURCE}/src/package/amalgamate.cmake)
count_fused(${SCRATCH}/thalweg.cpp fused)
expect("fused instructions of the two files" ${fused} 0)
count_fused(${SOURCE}/src/kernel/predicates.cpp fused)
expect("fused instructions of src/kernel/predicates.cpp" ${fused} 0)

file(READ ${SCRATCH}/thalweg.cpp text)
string(REGEX REPLACE "#pragma (STDC FP_CONTRACT|GCC optimize)[^\n]*" "" text "${text}")
file(WRITE ${SCRATCH}/unguarded.cpp "${text}")
count_fused(${SCRATCH}/unguarded.cpp fused)
if(fused EQUAL 0)
  message(FATAL_ERROR "nothing is fused without the pragmas: this test shows nothing")
endif()
