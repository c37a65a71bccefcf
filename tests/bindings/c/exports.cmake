# The functions that the shared LIBRARY shows are those that HEADER declares, all of them and no others. NM is nm.
cmake_minimum_required(VERSION 3.22)
execute_process(COMMAND ${NM} --dynamic --defined-only --format=posix ${LIBRARY} OUTPUT_VARIABLE symbols
                COMMAND_ERROR_IS_FATAL ANY)
string(REGEX MATCHALL "(^|\n)[^ \n]+" shown "${symbols}")
list(TRANSFORM shown REPLACE "[\n]" "")
file(READ ${HEADER} text)
string(REGEX MATCHALL "THALWEG_API [a-z0-9_* ]*thalweg_[a-z0-9_]+\\(" declared "${text}")
list(TRANSFORM declared REPLACE ".*(thalweg_[a-z0-9_]+)\\(" "\\1")
list(SORT shown)
list(SORT declared)
if(NOT declared OR NOT shown STREQUAL declared)
  message(FATAL_ERROR "declared: ${declared}\n\nshown: ${shown}")
endif()
