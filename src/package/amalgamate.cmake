# Writes the library as two files, OUTPUT/thalweg.hpp and OUTPUT/thalweg.cpp: the same bytes from the same sources,
# wherever they lie and whenever it runs.
#
#     cmake -D ROOT=<checkout> -D OUTPUT=<folder> -D VERSION=<version> -D SOURCES=<a.cpp,b.cpp> -P amalgamate.cmake
#
# SOURCES are relative to ROOT/src. Every file appears once, after the files that it includes. All sources become one
# translation unit, so no two of them may give the same name to different things in their anonymous namespaces.
#
# In CMake's own language, because whoever builds thalweg has CMake, and may have nothing else.
cmake_minimum_required(VERSION 3.22)

set(include_line "(^|\n)#include \"([^\"\n]+)\"[^\n]*")

# The "..." includes of a text, in order.
function(includes_of text out)
  string(REGEX MATCHALL "${include_line}" lines "${text}")
  list(TRANSFORM lines REPLACE "${include_line}" "\\2")
  set(${out} "${lines}" PARENT_SCOPE)
endfunction()

# Appends a file to the property `into`, behind what it includes, unless a file has it already.
function(append_file name into)
  get_property(seen GLOBAL PROPERTY seen)
  if(name IN_LIST seen)
    return()
  endif()
  set_property(GLOBAL APPEND PROPERTY seen ${name})
  if(name MATCHES "^thalweg/")
    if(into STREQUAL source)
      message(FATAL_ERROR "amalgamate: ${name} is not reached from thalweg/thalweg.hpp")
    endif()
    file(READ ${ROOT}/include/${name} text)
  else()
    file(READ ${ROOT}/src/${name} text)
  endif()
  includes_of("${text}" names)
  foreach(included IN LISTS names)
    append_file(${included} ${into})
  endforeach()
  string(REGEX REPLACE "${include_line}" "" text "${text}")
  string(REGEX REPLACE "(^|\n)#pragma once[^\n]*" "" text "${text}")
  string(REGEX REPLACE "\n\n\n+" "\n\n" text "${text}")
  string(STRIP "${text}" text)
  set_property(GLOBAL APPEND_STRING PROPERTY ${into} "\n// ==== ${name} ====\n\n${text}\n")
endfunction()

file(READ ${ROOT}/LICENSE license)
string(STRIP "${license}" license)
string(REGEX REPLACE "\n" "\n// " license "// ${license}")
string(REGEX REPLACE "// +\n" "//\n" license "${license}")

append_file(thalweg/thalweg.hpp header)
string(REPLACE "," ";" sources "${SOURCES}")
foreach(source IN LISTS sources)
  append_file(${source} source)
endforeach()
get_property(header GLOBAL PROPERTY header)
get_property(source GLOBAL PROPERTY source)

file(WRITE ${OUTPUT}/thalweg.hpp
"// thalweg ${VERSION} as one header and one source, made from its sources: changes belong there.
//
${license}
#pragma once
${header}")

file(WRITE ${OUTPUT}/thalweg.cpp
"// thalweg ${VERSION} as one header and one source, made from its sources: changes belong there.
//
//     c++ -std=c++20 -O2 app.cpp thalweg.cpp
//
${license}

// Before anything else, so that it holds for every function: no fused multiply-add, no other order of operations,
// whatever the flags.
#if defined(__clang__)
#pragma STDC FP_CONTRACT OFF
#pragma clang fp reassociate(off)
#elif defined(__GNUC__)
#pragma GCC optimize(\"fp-contract=off\")
#endif

#include \"thalweg.hpp\"

#define THALWEG_VERSION \"${VERSION}\"
${source}")
