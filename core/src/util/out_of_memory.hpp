#pragma once

#include <cstddef>
#include <string>

#include "meshbound/status.hpp"

namespace meshbound {

/// What a call returns where memory runs out while it is "reducing", "cutting" … so many triangles, `how` if there is more to say.
inline Status out_of_memory(const std::string& doing, std::size_t triangles, const std::string& how = "") {
    return {Fault::out_of_memory,
            "There is no memory left for " + doing + " " + std::to_string(triangles) + " triangles" + how + ".",
            "",
            {}};
}

} // namespace meshbound
