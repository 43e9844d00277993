#pragma once

#include <cstdint>
#include <vector>

#include "meshbound/map.hpp"

namespace meshbound {

/// How a level passes into the next coarser one.
struct LevelMap {
    std::vector<std::uint32_t> vertices; ///< for each vertex of the coarser level its index in the finer one, rising
    SurfaceMap map;                      ///< from the finer level onto the coarser one; its "input" is the finer level
    /// No point of the finer level lies farther from its image: one value a variable, position first, in its unit.
    std::vector<double> errors;
};

} // namespace meshbound
