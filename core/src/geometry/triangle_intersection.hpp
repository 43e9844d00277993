#pragma once

#include <array>
#include <cstdint>

#include <glm/vec3.hpp>

namespace meshbound {

/// A triangle in space. Its corners are compared by the ids of their points (see point_ids), not by vertex: triangles
/// on the two sides of a seam, where vertices are doubled, share corners and edges all the same.
struct SpatialTriangle {
    std::array<std::uint32_t, 3> ids;
    std::array<glm::dvec3, 3> points;
};

/// Whether two triangles intersect beyond the corners and edges that they share: one crosses or touches the other, or
/// they overlap. Exact. Of a degenerate triangle it may report an intersection that does not exist, but never misses
/// one between a triangle with an area and the other's edges.
bool intersect_beyond_shared(const SpatialTriangle& one, const SpatialTriangle& other);

} // namespace meshbound
