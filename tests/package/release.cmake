# The archive of a release: the same bytes from copies of the checkout of different age, place and rights, and in it
# what belongs there. SOURCES are the library's, relative to src.
cmake_minimum_required(VERSION 3.22)
include(${CMAKE_CURRENT_LIST_DIR}/steps.cmake)

function(pack root out)
  run(ignored ${CMAKE_COMMAND} -D ROOT=${root} -D OUTPUT=${SCRATCH}/${out} -D VERSION=${VERSION} -D SOURCES=${SOURCES}
              -D TAR=${TAR} -P ${SOURCE}/src/package/release.cmake)
endfunction()

file(REMOVE_RECURSE ${SCRATCH})
pack(${SOURCE} first)
file(COPY ${SOURCE}/include ${SOURCE}/src ${SOURCE}/LICENSE ${SOURCE}/README.md DESTINATION "${SCRATCH}/another place")
file(TOUCH "${SCRATCH}/another place/LICENSE")
file(CHMOD "${SCRATCH}/another place/README.md" PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE)
pack("${SCRATCH}/another place" second)

set(name thalweg-${VERSION})
set(archive ${name}.tar.gz)
file(SHA256 ${SCRATCH}/first/${archive} first)
file(SHA256 ${SCRATCH}/second/${archive} second)
expect("the archive made again" ${second} ${first})
run(listing ${TAR} -tzf ${SCRATCH}/first/${archive})
expect("what is in the archive" "${listing}"
       "${name}/\n${name}/LICENSE\n${name}/README.md\n${name}/thalweg.cpp\n${name}/thalweg.hpp\n")
