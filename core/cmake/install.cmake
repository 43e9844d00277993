# Installs the library so that find_package(meshbound) and pkg-config find it.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

set(MESHBOUND_CONFIG_DIR ${CMAKE_INSTALL_LIBDIR}/cmake/meshbound)

install(TARGETS meshbound EXPORT meshbound-targets)
install(DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR}/include/meshbound DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(EXPORT meshbound-targets NAMESPACE meshbound:: DESTINATION ${MESHBOUND_CONFIG_DIR})

configure_package_config_file(
    ${CMAKE_CURRENT_LIST_DIR}/meshbound-config.cmake.in
    ${CMAKE_CURRENT_BINARY_DIR}/meshbound-config.cmake
    INSTALL_DESTINATION ${MESHBOUND_CONFIG_DIR})
write_basic_package_version_file(
    ${CMAKE_CURRENT_BINARY_DIR}/meshbound-config-version.cmake
    VERSION ${MESHBOUND_VERSION}
    COMPATIBILITY SameMinorVersion)
install(
    FILES
        ${CMAKE_CURRENT_BINARY_DIR}/meshbound-config.cmake
        ${CMAKE_CURRENT_BINARY_DIR}/meshbound-config-version.cmake
        ${CMAKE_CURRENT_LIST_DIR}/Findglm.cmake
    DESTINATION ${MESHBOUND_CONFIG_DIR})

# The folders of the .pc file are found from where the file lies, so that an installation can be moved.
set(pkgconfig_dir ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
file(RELATIVE_PATH MESHBOUND_PC_PREFIX /${pkgconfig_dir} /)
string(REGEX REPLACE "/$" "" MESHBOUND_PC_PREFIX "${MESHBOUND_PC_PREFIX}")
if(library_type STREQUAL "SHARED_LIBRARY")
    set(MESHBOUND_PC_DEFINITION " -DMESHBOUND_SHARED")
else()
    set(MESHBOUND_PC_THREADS ${CMAKE_THREAD_LIBS_INIT})
endif()
configure_file(${CMAKE_CURRENT_LIST_DIR}/meshbound.pc.in ${CMAKE_CURRENT_BINARY_DIR}/meshbound.pc @ONLY)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/meshbound.pc DESTINATION ${pkgconfig_dir})
