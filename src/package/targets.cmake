# What a maintainer asks for by name: the two files, the archive of a release, the reference.
get_property(sources GLOBAL PROPERTY THALWEG_SOURCES)
set(arguments -D ROOT=${PROJECT_SOURCE_DIR} -D VERSION=${PROJECT_VERSION} -D SOURCES=${sources})

add_custom_target(amalgamate
    COMMAND ${CMAKE_COMMAND} ${arguments} -D OUTPUT=${PROJECT_BINARY_DIR}/amalgamated
            -P ${CMAKE_CURRENT_LIST_DIR}/amalgamate.cmake
    COMMENT "Writing amalgamated/thalweg.hpp and amalgamated/thalweg.cpp" VERBATIM)

find_program(THALWEG_TAR tar)
mark_as_advanced(THALWEG_TAR)
if(THALWEG_TAR)
  add_custom_target(release
      COMMAND ${CMAKE_COMMAND} ${arguments} -D OUTPUT=${PROJECT_BINARY_DIR}/release -D TAR=${THALWEG_TAR}
              -P ${CMAKE_CURRENT_LIST_DIR}/release.cmake
      COMMENT "Packing release/thalweg-${PROJECT_VERSION}.tar.gz" VERBATIM)
endif()

# The target `reference`, and a test: the headers must say everything.
find_program(THALWEG_DOXYGEN doxygen)
mark_as_advanced(THALWEG_DOXYGEN)
if(THALWEG_DOXYGEN)
  set(reference_output ${PROJECT_BINARY_DIR}/reference)
  configure_file(${CMAKE_CURRENT_LIST_DIR}/Doxyfile.in ${reference_output}/Doxyfile @ONLY)
  add_custom_target(reference COMMAND ${THALWEG_DOXYGEN} ${reference_output}/Doxyfile
                    COMMENT "Writing reference/html/index.html" VERBATIM)
endif()
