# Compiles with the Emscripten that is on the PATH, so that `cmake --preset wasm` works without emcmake.
if(NOT DEFINED EMSCRIPTEN_ROOT_PATH)
    execute_process(
        COMMAND em-config EMSCRIPTEN_ROOT
        OUTPUT_VARIABLE EMSCRIPTEN_ROOT_PATH
        OUTPUT_STRIP_TRAILING_WHITESPACE
        RESULT_VARIABLE em_config_result)
    if(NOT em_config_result EQUAL 0)
        message(FATAL_ERROR "em-config was not found: install Emscripten (Debian: emscripten) or activate emsdk.")
    endif()
endif()

include(${EMSCRIPTEN_ROOT_PATH}/cmake/Modules/Platform/Emscripten.cmake)
