#pragma once

#include <cstdint>
#include <vector>

#include "errors/error_model.hpp"
#include "meshbound/reduction.hpp"
#include "metric/rows.hpp"
#include "reduction/sweep.hpp"
#include "surface/surface.hpp"
#include "util/progress_reporter.hpp"
#include "util/thread_pool.hpp"

namespace meshbound {

/// Indices in the reduced mesh by those in the input: vertices in rising order, triangles in the order of their slots.
struct ReducedIndices {
    std::vector<std::uint32_t> vertex, triangle;
};

/// The part of a report that is known before anything is removed.
Report begin_report(const Mesh& mesh, const std::vector<ResolvedBound>& bounds, const MeshDefects& defects);

/// Writes the surface out as the reduced mesh, with the vertices that it keeps.
ReducedIndices extract_mesh(const Mesh& mesh, const Surface& surface, Reduction& reduction);

/// The errors of every triangle and the largest of them all. Stops where the caller cancels, incomplete.
void extract_errors(const Surface& surface, const Rows& rows, const ErrorModel& error_model, Reduction& reduction,
                    ThreadPool& pool, ProgressReporter& reporter);

/// Counts for what reasons the vertices that are left could not be removed.
void count_refusals(const Surface& surface, const Sweeper& sweeper, Report& report);

/// How many input vertices are left.
std::size_t count_vertices(const Surface& surface);

/// The errors of a cancelled reduction: the bounds that its sweeps kept, without measuring any triangle.
void report_limits(const Multipliers& multipliers, Report& report);

} // namespace meshbound
