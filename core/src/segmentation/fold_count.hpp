#pragma once

#include <cstdint>
#include <vector>

#include "meshbound/segmentation.hpp"
#include "util/progress_reporter.hpp"
#include "util/thread_pool.hpp"

namespace meshbound {

/// The size of a segmentation.
struct Folds {
    std::size_t cells = 0, folded_cells = 0;
};

/// By original triangle, how many sides it has, which is how often it counts; empty: one each.
using Sides = std::vector<std::uint8_t>;

/// Counts without keeping the segmentation. The original must be oriented consistently. Zero where the caller cancels.
Folds count_folds(const MappedSurfaces& surfaces, const Sides& sides, ThreadPool& pool, ProgressReporter& reporter);

} // namespace meshbound
