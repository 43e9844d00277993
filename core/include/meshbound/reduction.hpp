#pragma once

#include <cstdint>
#include <vector>

#include "meshbound/map.hpp"
#include "meshbound/mesh.hpp"
#include "meshbound/report.hpp"

namespace meshbound {

/// The error of one variable on every triangle of the reduced mesh, in the variable's unit, rounded up to single precision.
struct TriangleErrors {
    /// No point of the original that lies in this triangle has a larger error. One value a triangle; NaN where it is not known,
    /// because the variable is NaN or infinite there, in the original or in the result. With propagated errors it is then not
    /// known of any triangle.
    std::vector<float> largest;
    /// The signed error, original minus reduced, lies between these. One value a triangle; for position the distance along
    /// the normal, positive outside (§3.3.1, a diagnostic, not a bound); NaN where it is not known. Empty for a variable with
    /// several components.
    std::vector<float> lowest, highest;
    /// The largest of error / bound of these points, the bound multiplied as it is at each (Options::bound_multiplier), rounded up; 0
    /// where the variable is free. One value a triangle.
    std::vector<float> ratio;
};

/// The outcome of a reduction.
struct Reduction {
    Mesh mesh;                                   ///< the reduced mesh: all variables of the input, in their order
    std::vector<std::uint32_t> vertices;         ///< for each of its vertices the index in the input, rising
    std::vector<TriangleErrors> triangle_errors; ///< position first, then the mesh's variables in their order
    SurfaceMap map;                              ///< tracked errors only, empty else
    std::vector<VertexErrors> vertex_errors;     ///< tracked errors only; position first, then the mesh's variables
    Report report;
};

} // namespace meshbound
