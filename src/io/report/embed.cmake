# Turns text files into one C++ source of string constants, with nothing but CMake:
#
#     cmake -D OUTPUT=FILE -D FOLDER=src/io/report -P embed.cmake
#
# The text goes into raw string literals of at most 12,000 characters, one after the other, which the compiler joins.
cmake_minimum_required(VERSION 3.22)

set(styles style.css)
set(scripts text.js payload.js mesh.js colour.js shade.js view.js layers.js map.js hover.js figures.js table.js scene.js
            app.js)

function(constant name text)
  string(LENGTH "${text}" length)
  set(literals "\"\"\n")
  set(at 0)
  while(at LESS length)
    string(SUBSTRING "${text}" ${at} 12000 piece)
    string(APPEND literals "R\"embedded(${piece})embedded\"\n")
    math(EXPR at "${at} + 12000")
  endwhile()
  file(APPEND ${OUTPUT}.new "const std::string_view ${name} =\n${literals};\n")
endfunction()

function(joined out)
  set(text "")
  foreach(file IN LISTS ARGN)
    file(READ ${FOLDER}/${file} content)
    string(APPEND text "${content}")
  endforeach()
  set(${out} "${text}" PARENT_SCOPE)
endfunction()

# Every compiler at hand takes literals of a megabyte; clang asks whether others would.
file(WRITE ${OUTPUT}.new "#pragma GCC diagnostic ignored \"-Woverlength-strings\"\n#include \"io/report_assets.hpp\"\nnamespace thalweg::io {\n")
joined(page page.html)
constant(kReportPage "${page}")
joined(style ${styles})
constant(kReportStyle "${style}")
joined(script ${scripts})
constant(kReportScript "(() => {\n'use strict';\n${script}})();\n")
joined(three bundle/three.js)
constant(kThreeScript "${three}")
joined(licence bundle/LICENSE-three.txt)
constant(kThreeLicence "${licence}")
file(APPEND ${OUTPUT}.new "}  // namespace thalweg::io\n")
file(RENAME ${OUTPUT}.new ${OUTPUT})
