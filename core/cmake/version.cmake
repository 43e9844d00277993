# MESHBOUND_VERSION ("0.1.0") and its parts, from their one home, meshbound/version.hpp.
# Without "..": a file that a build depends on under two names is two files to Ninja.
cmake_path(SET version_header NORMALIZE ${CMAKE_CURRENT_LIST_DIR}/../include/meshbound/version.hpp)
foreach(part IN ITEMS MAJOR MINOR PATCH)
    file(STRINGS ${version_header} line REGEX "^#define MESHBOUND_VERSION_${part} [0-9]+$")
    string(REGEX MATCH "[0-9]+$" MESHBOUND_VERSION_${part} "${line}")
    if(MESHBOUND_VERSION_${part} STREQUAL "")
        message(FATAL_ERROR "${version_header} does not define MESHBOUND_VERSION_${part}.")
    endif()
endforeach()
set(MESHBOUND_VERSION ${MESHBOUND_VERSION_MAJOR}.${MESHBOUND_VERSION_MINOR}.${MESHBOUND_VERSION_PATCH})
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${version_header})
unset(version_header)
unset(line)
