#pragma once

/// The version of these headers, for the preprocessor. This is its one home: CMake reads the three numbers from here, and
/// names the shared library after them. As long as the first is 0, a new second number may break what was built before.
#define MESHBOUND_VERSION_MAJOR 0
#define MESHBOUND_VERSION_MINOR 1
#define MESHBOUND_VERSION_PATCH 0

#define MESHBOUND_TEXT_OF(number) #number
#define MESHBOUND_VERSION_TEXT(major, minor, patch)                                                                    \
    MESHBOUND_TEXT_OF(major) "." MESHBOUND_TEXT_OF(minor) "." MESHBOUND_TEXT_OF(patch)

/// The same as text: "0.1.0".
#define MESHBOUND_VERSION                                                                                              \
    MESHBOUND_VERSION_TEXT(MESHBOUND_VERSION_MAJOR, MESHBOUND_VERSION_MINOR, MESHBOUND_VERSION_PATCH)
