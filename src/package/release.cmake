# Writes OUTPUT/thalweg-VERSION.tar.gz: the library as two files, the licence and the README. The same bytes from the
# same sources: no date, no owner, fixed rights and order. Takes GNU tar as TAR; the rest as amalgamate.cmake.
cmake_minimum_required(VERSION 3.22)

set(name thalweg-${VERSION})
file(REMOVE_RECURSE ${OUTPUT}/${name})
file(MAKE_DIRECTORY ${OUTPUT}/${name})
execute_process(COMMAND ${CMAKE_COMMAND} -D ROOT=${ROOT} -D OUTPUT=${OUTPUT}/${name} -D VERSION=${VERSION}
                        -D SOURCES=${SOURCES} -P ${CMAKE_CURRENT_LIST_DIR}/amalgamate.cmake
                COMMAND_ERROR_IS_FATAL ANY)
file(COPY ${ROOT}/LICENSE ${ROOT}/README.md DESTINATION ${OUTPUT}/${name}
     FILE_PERMISSIONS OWNER_READ OWNER_WRITE GROUP_READ WORLD_READ)
execute_process(COMMAND ${TAR} --create --format=ustar --sort=name --mtime=@0 --owner=root:0 --group=root:0
                        --mode=u=rwX,go=rX "--use-compress-program=gzip -n -9" --file=${name}.tar.gz ${name}
                WORKING_DIRECTORY ${OUTPUT} COMMAND_ERROR_IS_FATAL ANY)
