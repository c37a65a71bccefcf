# Checks what no compiler does, file by file, and names each offence as FILE:LINE.
#
#     cmake -D ROOT=<checkout> -P layers.cmake
#
#   - a layer includes only itself and earlier ones: kernel, order, terrain, io, cli, bindings;
#   - io knows the library by its public headers alone; public headers include public headers alone;
#   - the libraries of the command (CLI11, nlohmann-json) stay in cli;
#   - no <iostream> in the library; sources are plain ASCII.
cmake_minimum_required(VERSION 3.22)
include(${CMAKE_CURRENT_LIST_DIR}/public_headers.cmake)
get_filename_component(ROOT ${ROOT} ABSOLUTE)

set(layers kernel order terrain io cli bindings)

function(offend place what)
  set_property(GLOBAL APPEND_STRING PROPERTY offences "${place}: ${what}\n")
endfunction()

# The layer of what is included as "path", with how it is reached: public or internal. Empty if it is neither.
function(layer_of path out_layer out_kind)
  set(layer "")
  set(kind "")
  if(path MATCHES "^thalweg/([^/]+)$")
    set(kind public)
    foreach(candidate IN LISTS layers)
      if(CMAKE_MATCH_1 IN_LIST ${candidate}_headers)
        set(layer ${candidate})
      endif()
    endforeach()
  elseif(path MATCHES "^([a-z]+)/" AND CMAKE_MATCH_1 IN_LIST layers)
    set(layer ${CMAKE_MATCH_1})
    set(kind internal)
  endif()
  set(${out_layer} "${layer}" PARENT_SCOPE)
  set(${out_kind} "${kind}" PARENT_SCOPE)
endfunction()

function(check_quoted_include place from from_kind path)
  layer_of(${path} to to_kind)
  list(FIND layers "${from}" from_rank)
  list(FIND layers "${to}" to_rank)
  if(NOT to)
    offend(${place} "\"${path}\" is neither a listed public header (tests/checks/public_headers.cmake) nor LAYER/...")
  elseif(to_rank GREATER from_rank)
    offend(${place} "${from} includes \"${path}\" of the later layer ${to}")
  elseif(from_kind STREQUAL public AND to_kind STREQUAL internal)
    offend(${place} "a public header includes the internal \"${path}\"")
  elseif(from STREQUAL io AND to_kind STREQUAL internal AND NOT to STREQUAL io)
    offend(${place} "io includes the internal \"${path}\" of ${to}: public headers only")
  endif()
endfunction()

function(check_system_include place from header)
  if(header STREQUAL iostream AND from MATCHES "^(kernel|order|terrain)$")
    offend(${place} "<iostream> in the library")
  elseif(header MATCHES "^(CLI|nlohmann)/" AND NOT from STREQUAL cli)
    offend(${place} "<${header}> outside cli")
  elseif(header MATCHES "^thalweg/")
    offend(${place} "<${header}>: write \"${header}\"")
  endif()
endfunction()

function(check_line place from kind line)
  if(line MATCHES "[^\t -~]")
    offend(${place} "not ASCII")
  endif()
  if(line MATCHES "^[ \t]*#[ \t]*include[ \t]*\"([^\"]*)\"")
    check_quoted_include(${place} ${from} ${kind} ${CMAKE_MATCH_1})
  elseif(line MATCHES "^[ \t]*#[ \t]*include[ \t]*<([^>]*)>")
    check_system_include(${place} ${from} ${CMAKE_MATCH_1})
  endif()
endfunction()

# Brackets and semicolons mean something to CMake's lists and nothing to this check.
function(read_lines file out)
  file(READ ${file} text)
  string(REGEX REPLACE "[][;\\]" "?" text "${text}")
  string(REPLACE "\n" ";" text "${text}")
  set(${out} "${text}" PARENT_SCOPE)
endfunction()

file(GLOB_RECURSE files RELATIVE ${ROOT} ${ROOT}/include/*.h ${ROOT}/include/*.hpp ${ROOT}/src/*.c ${ROOT}/src/*.cpp
     ${ROOT}/src/*.h ${ROOT}/src/*.hpp)
list(LENGTH files count)
if(count EQUAL 0)
  message(FATAL_ERROR "layers: no sources under ${ROOT}")
endif()

foreach(file IN LISTS files)
  string(REGEX REPLACE "^(include|src)/" "" inside ${file})
  layer_of(${inside} from kind)
  if(NOT from)
    offend("${file}:1" "belongs to no layer (src/LAYER/..., or include/thalweg/ and tests/checks/public_headers.cmake)")
    continue()
  endif()
  read_lines(${ROOT}/${file} lines)
  set(number 0)
  foreach(line IN LISTS lines)
    math(EXPR number "${number} + 1")
    check_line("${file}:${number}" ${from} ${kind} "${line}")
  endforeach()
endforeach()

get_property(offences GLOBAL PROPERTY offences)
if(offences)
  message(NOTICE "${offences}")  # a fatal error would be wrapped and indented
  message(FATAL_ERROR "layers: the rules at the head of tests/checks/layers.cmake are broken, see above")
endif()
message(STATUS "layers: ${count} files are in order")
