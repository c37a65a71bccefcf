# The library as two files, made here anew: twice the same bytes wherever the sources lie, then compiled and run by the
# README's command with COMPILER. SOURCES are the library's, relative to src.
cmake_minimum_required(VERSION 3.22)
include(${CMAKE_CURRENT_LIST_DIR}/steps.cmake)

function(amalgamate root output)
  run(ignored ${CMAKE_COMMAND} -D ROOT=${root} -D OUTPUT=${output} -D VERSION=${VERSION} -D SOURCES=${SOURCES}
              -P ${SOURCE}/src/package/amalgamate.cmake)
endfunction()

file(REMOVE_RECURSE ${SCRATCH})
amalgamate(${SOURCE} ${SCRATCH})
file(COPY ${SOURCE}/include ${SOURCE}/src ${SOURCE}/LICENSE DESTINATION "${SCRATCH}/another place")
amalgamate("${SCRATCH}/another place" ${SCRATCH}/again)
foreach(name thalweg.hpp thalweg.cpp)
  file(READ ${SCRATCH}/${name} text)
  file(READ ${SCRATCH}/again/${name} again)
  if(NOT text STREQUAL again)
    message(FATAL_ERROR "${name} is not the same from another folder")
  endif()
  string(FIND "${text}" "${SOURCE}" at)
  expect("place of the path of the checkout in ${name}" ${at} -1)
  if(text MATCHES "(^|\n)[ \t]*#[ \t]*include \"(kernel|order|terrain|thalweg/)[^\n]*")
    message(FATAL_ERROR "${name} needs another file: ${CMAKE_MATCH_0}")
  endif()
endforeach()

file(READ ${CMAKE_CURRENT_LIST_DIR}/consumer/uses_thalweg.cpp app)
string(REPLACE "<thalweg/thalweg.hpp>" "\"thalweg.hpp\"" app "${app}")
file(WRITE ${SCRATCH}/app.cpp "${app}")
readme_command("thalweg\\.cpp" command)
run_in(${SCRATCH} ignored sh -ec "${command} ${strict} && ./app ${VERSION}")
