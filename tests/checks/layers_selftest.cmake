# Runs layers.cmake on small trees made for it: a sound one must pass, each broken one must fail and name the place.
#
#     cmake -D SCRATCH=<directory to overwrite> -P layers_selftest.cmake
cmake_minimum_required(VERSION 3.22)

# judge(RESULT OUTPUT): what layers.cmake says of the tree in SCRATCH.
function(judge out_result out_output)
  execute_process(COMMAND ${CMAKE_COMMAND} -D ROOT=${SCRATCH} -P ${CMAKE_CURRENT_LIST_DIR}/layers.cmake
                  RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
  set(${out_result} "${result}" PARENT_SCOPE)
  set(${out_output} "${output}" PARENT_SCOPE)
endfunction()

function(write_sound_tree)
  file(REMOVE_RECURSE ${SCRATCH})
  file(WRITE ${SCRATCH}/include/thalweg/id.hpp "#include <compare>\nint a[2];\n")
  file(WRITE ${SCRATCH}/include/thalweg/pits.hpp "#include \"thalweg/id.hpp\"\n")
  file(WRITE ${SCRATCH}/src/kernel/a.hpp "#include \"thalweg/id.hpp\"\n")
  file(WRITE ${SCRATCH}/src/terrain/b.cpp "#include \"kernel/a.hpp\"\n#include \"thalweg/pits.hpp\"\n")
  file(WRITE ${SCRATCH}/src/io/c.cpp "#include \"thalweg/pits.hpp\"\n")
  file(WRITE ${SCRATCH}/src/cli/d.cpp "#include <CLI/CLI.hpp>\n#include <iostream>\n#include \"io/c.hpp\"\n")
endfunction()

# Two sound lines, then the bad one: the report must name line 3 and the reason.
function(expect_offence file line reason)
  write_sound_tree()
  file(WRITE ${SCRATCH}/${file} "/// purpose\n\n${line}\n")
  judge(result output)
  string(FIND "${output}" "${file}:3: " at)
  if(result EQUAL 0 OR at EQUAL -1 OR NOT output MATCHES "${reason}")
    message(FATAL_ERROR "the check missed ${file}:3 '${line}', said:\n${output}")
  endif()
endfunction()

write_sound_tree()
judge(result output)
if(NOT result EQUAL 0)
  message(FATAL_ERROR "the check refuses a sound tree:\n${output}")
endif()

expect_offence(src/kernel/x.cpp "#include \"terrain/b.hpp\"" "later layer terrain")
expect_offence(src/kernel/x.hpp "  #  include \"thalweg/pits.hpp\"" "later layer terrain")
expect_offence(src/order/x.cpp "#include \"io/c.hpp\"" "later layer io")
expect_offence(src/io/x.cpp "#include \"kernel/a.hpp\"" "public headers only")
expect_offence(src/cli/x.cpp "#include \"bindings/e.hpp\"" "later layer bindings")
expect_offence(include/thalweg/id.hpp "#include \"kernel/a.hpp\"" "internal")
expect_offence(include/thalweg/point.hpp "#include \"thalweg/minimize.hpp\"" "later layer terrain")
expect_offence(include/thalweg/point.hpp "#include <iostream>" "<iostream>")
expect_offence(src/terrain/x.cpp "#include <iostream>" "<iostream>")
expect_offence(src/io/x.cpp "#include <nlohmann/json.hpp>" "outside cli")
expect_offence(src/order/x.cpp "#include \"a.hpp\"" "neither")
expect_offence(src/order/x.cpp "#include \"thalweg/unheard_of.hpp\"" "neither")
string(ASCII 195 182 accented)
expect_offence(src/order/x.cpp "// L${accented}ffler" "not ASCII")

write_sound_tree()
file(WRITE ${SCRATCH}/src/stray.cpp "\n")
judge(result output)
if(result EQUAL 0 OR NOT output MATCHES "src/stray.cpp:1: belongs to no layer")
  message(FATAL_ERROR "the check missed a source outside the layers, said:\n${output}")
endif()
