#pragma once

#include <cstdint>
#include <vector>

#include "meshbound/reduce.hpp"
#include "metric/rows.hpp"
#include "surface/surface.hpp"
#include "util/team.hpp"
#include "util/ticker.hpp"
#include "errors/tracked/tracking.hpp"

namespace meshbound {

/// Each of these stops where the ticker cancels, and leaves what it wrote incomplete.

/// Writes the tracked map out in terms of input and reduced mesh, with the errors at the input's vertices.
/// `renamed_vertex[v]` and `renamed_triangle[slot]`: their indices in the reduced mesh.
void extract_map(const Surface& surface, const Tracking& tracking, const std::vector<std::uint32_t>& renamed_vertex,
                 const std::vector<std::uint32_t>& renamed_triangle, SurfaceMap& map, Ticker& ticker);

/// The errors of every vertex of the input at its place (reduction.map, reduction.mesh and reduction.vertices are filled).
void extract_vertex_errors(const Rows& rows, const Surface& surface, const Reduction& reduction,
                           std::vector<VertexErrors>& errors, Team& team, Ticker& ticker);

} // namespace meshbound
