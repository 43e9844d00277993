# Installs the library so that find_package(meshbound) finds it with its dependency.
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
    COMPATIBILITY SameMinorVersion)
install(
    FILES
        ${CMAKE_CURRENT_BINARY_DIR}/meshbound-config.cmake
        ${CMAKE_CURRENT_BINARY_DIR}/meshbound-config-version.cmake
        ${CMAKE_CURRENT_LIST_DIR}/Findglm.cmake
    DESTINATION ${MESHBOUND_CONFIG_DIR})
