# The compilers that are supported, and the options that they have in common under different names.
#
# GCC from 12, Clang from 14 (Apple's from 14, and clang-cl on Windows), Emscripten from 3.1.6. The core uses the vector types
# that these share (rows of numbers, two at a time, with the same bytes everywhere); Microsoft's cl has none.
function(meshbound_check_compiler)
    set(oldest_GNU 12)
    set(oldest_Clang 14)
    set(oldest_AppleClang 14)
    set(oldest ${oldest_${CMAKE_CXX_COMPILER_ID}})
    if(EMSCRIPTEN) # its Clang may call itself a version ahead of a release
        if(EMSCRIPTEN_VERSION VERSION_LESS 3.1.6)
            message(FATAL_ERROR "Meshbound needs Emscripten 3.1.6 or newer; this is ${EMSCRIPTEN_VERSION}.")
        endif()
    elseif(NOT oldest)
        message(FATAL_ERROR "Meshbound is built by GCC, Clang (on Windows clang-cl) or Emscripten, not by "
            "${CMAKE_CXX_COMPILER_ID}. Set CMAKE_CXX_COMPILER.")
    elseif(CMAKE_CXX_COMPILER_VERSION VERSION_LESS oldest)
        message(FATAL_ERROR "Meshbound needs ${CMAKE_CXX_COMPILER_ID} ${oldest} or newer; this is "
            "${CMAKE_CXX_COMPILER_VERSION}.")
    endif()
endfunction()
meshbound_check_compiler()

# Contraction to fused multiply-add would give other bytes on other machines.
if(CMAKE_CXX_COMPILER_FRONTEND_VARIANT STREQUAL "MSVC")
    set(MESHBOUND_EXACT_ARITHMETIC /clang:-ffp-contract=off)
    set(MESHBOUND_WARNINGS /W4)
else()
    set(MESHBOUND_EXACT_ARITHMETIC -ffp-contract=off)
    set(MESHBOUND_WARNINGS -Wall -Wextra -Wpedantic -Wshadow)
endif()
