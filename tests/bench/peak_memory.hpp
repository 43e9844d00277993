#pragma once

#include <fstream>
#include <string>

#ifdef __GLIBC__
#include <malloc.h>
#endif

/// Memory of this process as Linux counts it; zeros elsewhere.
namespace bench {

/// A line of /proc/self/status, "VmHWM:   123 kB", in bytes.
inline double status_bytes(const std::string& key) {
    std::ifstream status("/proc/self/status");
    for (std::string line; std::getline(status, line);)
        if (line.rfind(key + ":", 0) == 0) return 1024 * std::stod(line.substr(key.size() + 1));
    return 0;
}

inline double resident_bytes() { return status_bytes("VmRSS"); }

/// The most that was resident since the start, or since forget_peak.
inline double peak_bytes() { return status_bytes("VmHWM"); }

/// Gives back what is free and begins the peak anew: reading a file needs more than what is read.
inline void forget_peak() {
#ifdef __GLIBC__
    malloc_trim(0);
#endif
    std::ofstream("/proc/self/clear_refs") << 5;
}

} // namespace bench
