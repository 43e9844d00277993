#pragma once

#include "meshbound/segmentation.hpp"
#include "team.hpp"
#include "ticker.hpp"

namespace meshbound {

/// How much of a segmentation there is.
struct Folds {
    std::size_t cells = 0, folded_cells = 0;
};

/// Counts without keeping anything; of an original whose triangles agree already which side is the front one. Nothing where
/// the ticker cancels.
Folds count_folds(const MappedSurfaces& surfaces, Team& team, Ticker& ticker);

} // namespace meshbound
