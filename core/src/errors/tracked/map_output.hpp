#pragma once

#include <cstdint>
#include <vector>

#include "errors/tracked/tracking.hpp"
#include "meshbound/reduction.hpp"
#include "metric/rows.hpp"
#include "surface/surface.hpp"
#include "util/progress_reporter.hpp"
#include "util/thread_pool.hpp"

namespace meshbound {

/// Each of these stops where the caller cancels, and leaves what it wrote incomplete.

/// Writes the tracked map out in terms of input and reduced mesh, with the errors at the input's vertices.
/// `reduced_vertex[v]` and `reduced_triangle[slot]`: their indices in the reduced mesh.
void extract_map(const Surface& surface, const Tracking& tracking, const std::vector<std::uint32_t>& reduced_vertex,
                 const std::vector<std::uint32_t>& reduced_triangle, SurfaceMap& map, ProgressReporter& reporter);

/// The errors of every input vertex at its image (reduction.map, reduction.mesh and reduction.vertices are filled).
void extract_vertex_errors(const Rows& rows, const Surface& surface, const Reduction& reduction,
                           std::vector<VertexErrors>& errors, ThreadPool& pool, ProgressReporter& reporter);

} // namespace meshbound
