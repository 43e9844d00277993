#pragma once

#include <cstddef>
#include <functional>
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

/// The same for any mesh, corners in one place counting as one, by looking at each pair of which `asked` holds: for small
/// meshes. Triangles without area are not looked at.
TrianglePairs soup_intersections(const meshbound::Mesh& mesh,
                                 const std::function<bool(std::size_t, std::size_t)>& asked);

} // namespace judge
