# Finds GLM by its headers and defines glm::glm.
#
# GLM's own package file does not work under the Emscripten toolchain, and a compiler for another system must not see the
# whole of /usr/include. So when cross-compiling the target exposes a folder that holds nothing but a link to GLM.

if(TARGET glm::glm)
    set(glm_FOUND TRUE)
    return()
endif()

# The usual folders are named because a cross-compiling toolchain leaves them out.
find_path(GLM_INCLUDE_DIR glm/glm.hpp
    PATHS /usr/local/include /usr/include /opt/homebrew/include
    NO_CMAKE_FIND_ROOT_PATH
    DOC "The folder that holds glm/glm.hpp")
mark_as_advanced(GLM_INCLUDE_DIR)

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(glm REQUIRED_VARS GLM_INCLUDE_DIR
    REASON_FAILURE_MESSAGE "Install GLM (Debian: libglm-dev) or set GLM_INCLUDE_DIR.")

if(glm_FOUND)
    set(glm_include_dir ${GLM_INCLUDE_DIR})
    if(CMAKE_CROSSCOMPILING)
        set(glm_include_dir ${CMAKE_CURRENT_BINARY_DIR}/glm-only)
        file(MAKE_DIRECTORY ${glm_include_dir})
        file(CREATE_LINK ${GLM_INCLUDE_DIR}/glm ${glm_include_dir}/glm SYMBOLIC)
    endif()
    add_library(glm::glm INTERFACE IMPORTED)
    set_target_properties(glm::glm PROPERTIES INTERFACE_INCLUDE_DIRECTORIES ${glm_include_dir})
    unset(glm_include_dir)
endif()
