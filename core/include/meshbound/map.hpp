#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "meshbound/glm_layout.hpp"

namespace meshbound {

/// "In no triangle": the place of a vertex that no triangle of the input uses.
inline constexpr std::uint32_t nowhere = std::numeric_limits<std::uint32_t>::max();

/// Where the map puts a vertex of the input: in this triangle of the reduced mesh, at these barycentric coordinates of its
/// three corners (0…1, sum 1). A removed vertex of a boundary or of a curve between sheets lies on an edge, and has exactly one
/// coordinate that is 0.
struct SurfacePoint {
    std::uint32_t triangle = nowhere;
    glm::dvec3 barycentric{0};
};

/// A place where an edge of the input, mapped, crosses an edge of the reduced mesh.
struct MapCrossing {
    glm::uvec2 original{0}; ///< the edge's two vertices in the input, the lower one first
    double s = 0;           ///< where along it: 0 at the first, 1 at the second
    glm::uvec2 reduced{0};  ///< the edge's two vertices in the reduced mesh
    double t = 0;           ///< where along it
    /// With s rising, passes from the left of the reduced edge (the triangle that has it from first to second vertex) to its
    /// right. Tells on which side it is where an edge is crossed to and fro.
    bool rightward = false;
};

/// The map Φ from the original surface onto the reduced one, by its corners (figure 5): cut every original triangle along
/// the chords between its crossings, and Φ is linear on a triangulation of each cell.
struct SurfaceMap {
    std::vector<SurfacePoint> images;   ///< one for each vertex of the input
    std::vector<MapCrossing> crossings; ///< grouped by original edge, each group with s rising
};

/// The errors of one variable at the vertices of the input, in its unit; NaN where it is not known, because the variable is NaN
/// or infinite there, in the original or in the result, and 0 at vertices that no triangle uses.
struct VertexErrors {
    std::vector<float> error; ///< length of (original - reduced)
    /// Original minus reduced; of position the distance along the reduced triangle's normal, positive where the reduced
    /// surface lies outside (§3.3.1). Empty for a variable with several components.
    std::vector<float> signed_error;
};

} // namespace meshbound
