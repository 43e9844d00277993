#pragma once

#include <cstdint>
#include <vector>

#include "meshbound/segmentation.hpp"
#include "util/team.hpp"
#include "util/ticker.hpp"

namespace meshbound {

/// How much of a segmentation there is.
struct Folds {
    std::size_t cells = 0, folded_cells = 0;
};

/// By the triangles of the original, how many sides each has, and so how many times what is found in it counts; empty: one.
using Sides = std::vector<std::uint8_t>;

/// Counts without keeping anything; of an original whose triangles agree already which side is the front one. Nothing where
/// the ticker cancels.
Folds count_folds(const MappedSurfaces& surfaces, const Sides& sides, Team& team, Ticker& ticker);

} // namespace meshbound
