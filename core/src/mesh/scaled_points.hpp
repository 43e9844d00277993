#pragma once

#include <vector>

#include <glm/vec3.hpp>

#include "meshbound/mesh.hpp"

namespace meshbound {

/// The positions of a mesh times a power of two, which is exact, so that products of a few coordinates neither overflow
/// nor underflow, whatever the unit.
struct ScaledPoints {
    std::vector<glm::dvec3> points; ///< by vertex; the origin where no triangle uses it
    int exponent = 0;               ///< they are 2^exponent as large as the mesh's
};

/// The largest coordinate becomes 2^largest_exponent or more, less than twice that. Where all are 0 they stay.
ScaledPoints scaled_points(const Mesh& mesh, int largest_exponent);

} // namespace meshbound
