# What the scripts of this folder share.

# What a careful embedder compiles with.
set(strict "-Wall -Wextra -Wpedantic -Wconversion -Wshadow -Werror -fno-rtti")

# Runs a command in a folder; it must succeed.
function(run_in folder out)
  execute_process(COMMAND ${ARGN} WORKING_DIRECTORY ${folder} RESULT_VARIABLE result OUTPUT_VARIABLE output
                  ERROR_VARIABLE output)
  if(NOT result EQUAL 0)
    message(NOTICE "${output}")
    message(FATAL_ERROR "failed (${result}): ${ARGN}")
  endif()
  set(${out} "${output}" PARENT_SCOPE)
endfunction()

macro(run out)
  run_in(. ${out} ${ARGN})
endmacro()

function(expect what got wanted)
  if(NOT got STREQUAL wanted)
    message(FATAL_ERROR "${what}:\n  got    ${got}\n  wanted ${wanted}")
  endif()
endfunction()

# The one line of the README's shell blocks that begins with g++ and has the word in it, for the COMPILER under test.
function(readme_command word out)
  file(STRINGS ${SOURCE}/README.md lines REGEX "^g\\+\\+ .*${word}")
  list(LENGTH lines count)
  expect("README's commands with ${word}" ${count} 1)
  string(REGEX REPLACE "^g\\+\\+ " "${COMPILER} " command "${lines}")
  set(${out} "${command}" PARENT_SCOPE)
endfunction()
