#pragma once

/// MESHBOUND_API marks what a shared library hands out; all else stays hidden in it. CMake and pkg-config define
/// MESHBOUND_SHARED for those who build or use a shared library, and nothing for a static one.
#if !defined(MESHBOUND_SHARED)
#define MESHBOUND_API
#elif !defined(_WIN32)
#define MESHBOUND_API __attribute__((visibility("default")))
#elif defined(MESHBOUND_BUILDING)
#define MESHBOUND_API __declspec(dllexport)
#else
#define MESHBOUND_API __declspec(dllimport)
#endif
