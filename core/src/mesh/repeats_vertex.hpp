#pragma once

#include <glm/vec3.hpp>

namespace meshbound {

/// Whether a triangle is degenerate: two of its indices are equal.
inline bool repeats_vertex(const glm::uvec3& triangle) {
    return triangle.x == triangle.y || triangle.y == triangle.z || triangle.z == triangle.x;
}

} // namespace meshbound
