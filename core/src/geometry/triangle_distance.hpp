#pragma once

#include <array>

#include <glm/vec3.hpp>

namespace meshbound {

using TrianglePoints = std::array<glm::dvec3, 3>;

/// Where two triangles come nearest to each other.
struct NearestPoints {
    double squared_distance = 0;
    /// The smallest simplex (corner, edge, face) that contains the nearest point: its corners, a bit each.
    unsigned one = 0, other = 0;
};

/// The nearest points of two triangles that do not intersect.
NearestPoints nearest_points(const TrianglePoints& one, const TrianglePoints& other);

} // namespace meshbound
