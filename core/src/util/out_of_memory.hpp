#pragma once

#include <cstddef>
#include <string>

#include "meshbound/status.hpp"

namespace meshbound {

/// The status of a call that ran out of memory. `doing`: a verb ("reducing", "cutting") for the message; `how`: what is
/// to stand behind the number of triangles.
inline Status out_of_memory(const std::string& doing, std::size_t triangles, const std::string& how = "") {
    return {Fault::out_of_memory,
            "There is no memory left for " + doing + " " + std::to_string(triangles) + " triangles" + how + ".",
            "",
            {}};
}

} // namespace meshbound
