# Flags that would change the arithmetic: each is refused, with a message that says what to do instead.

# arithmetic_case(NAME EXPECTED FLAG ...): compiling with these flags says something that matches EXPECTED. Flags that
# the compiler does not know, or has no standard library for, make a test that is skipped.
function(arithmetic_case name expected)
  set(test compile_fail.arithmetic_${name})
  execute_process(COMMAND ${CMAKE_CXX_COMPILER} -std=c++20 -fsyntax-only ${ARGN} -x c++ -include cstdint -include bit
                          /dev/null RESULT_VARIABLE unusable OUTPUT_QUIET ERROR_QUIET)
  if(unusable)
    add_test(NAME ${test} COMMAND ${CMAKE_COMMAND} -E echo "skipped: no ${CMAKE_CXX_COMPILER} ${ARGN} here")
    set_tests_properties(${test} PROPERTIES SKIP_REGULAR_EXPRESSION "skipped:")
    return()
  endif()
  add_test(NAME ${test}
           COMMAND ${CMAKE_CXX_COMPILER} -std=c++20 -O2 -S -o - ${ARGN} -I${PROJECT_SOURCE_DIR}/src
                   ${CMAKE_CURRENT_SOURCE_DIR}/arithmetic.cpp)
  set_tests_properties(${test} PROPERTIES PASS_REGULAR_EXPRESSION "${expected}" FAIL_REGULAR_EXPRESSION "warning:")
endfunction()

set(compiled "rounded")
set(fast "error: .*thalweg needs IEEE 754 arithmetic: compile without -ffast-math")
set(excess "error: .*thalweg needs double arithmetic without excess precision: .* -msse2 -mfpmath=sse")
arithmetic_case(control "${compiled}")
arithmetic_case(fast_math "${fast}" -ffast-math)
arithmetic_case(finite_math "${fast}" -ffinite-math-only)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  arithmetic_case(associative "${fast}" -fassociative-math -fno-signed-zeros -fno-trapping-math)
  arithmetic_case(reciprocal "${fast}" -freciprocal-math)
endif()
if(CMAKE_SYSTEM_PROCESSOR MATCHES "^(x86_64|AMD64)$")
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    arithmetic_case(x87 "${excess}" -mfpmath=387)
  else()
    arithmetic_case(associative "addsd.*subsd" -fassociative-math -fno-signed-zeros)
  endif()
  arithmetic_case(x87_32 "${excess}" -m32 -mno-sse)
  arithmetic_case(sse2_32 "${compiled}" -m32 -msse2 -mfpmath=sse)
endif()
