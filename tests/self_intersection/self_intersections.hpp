#pragma once

#include <cstddef>
#include <set>
#include <utility>

#include "meshbound/mesh.hpp"

/// A judge of piercing that knows nothing of the core's: CGAL's, with exact predicates.
namespace judge {

/// Pairs of triangles, the lower one first.
using TrianglePairs = std::set<std::pair<std::size_t, std::size_t>>;

/// Triangles that meet beyond the corners and edges that they share. For oriented manifolds; throws std::invalid_argument
/// for any other mesh.
TrianglePairs self_intersections(const meshbound::Mesh& mesh);

} // namespace judge
