#pragma once

#include <cstdint>
#include <vector>

#include "meshbound/api.hpp"
#include "meshbound/bounds.hpp"
#include "meshbound/checkpoint.hpp"
#include "meshbound/map.hpp"
#include "meshbound/mesh.hpp"
#include "meshbound/options.hpp"
#include "meshbound/report.hpp"
#include "meshbound/status.hpp"

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

/// Reduces a mesh so that every bound holds at every point of its surface:
///
/// > There is a continuous map from the original surface onto the reduced one that moves no point by more than the bound
/// > of `position` and changes no variable by more than its bound.
///
/// With Options::bound_multiplier it changes none by more than the bound times the multiplier at the original point.
///
/// Boundaries map to boundaries; genus, components and boundary loops are kept. The vertices of the result are a subset of
/// the input's, with their values bit for bit. The same input gives the same bytes on every machine.
///
/// Source: Bajaj & Schikore 1996, §3. Faults: those of validate and resolve_bounds, bad_option, too_large, out_of_memory;
/// `reduction` is then untouched. A cancelled call returns an ok status and a valid mesh, marked as cancelled; so that it
/// answers at once, its report gives the bounds for errors, and map, triangle and vertex errors are empty.
///
/// `checkpoint`, where given, is filled with the surface before the last sweep, which lies within the share of the bounds of the
/// sweep before that; Options::sweeps must have two sweeps at least. It changes nothing else, and takes a few percent of the
/// time, for its errors are measured. A call that is cancelled before leaves it untouched.
MESHBOUND_API Status reduce(const Mesh& mesh, const Bounds& bounds, const Options& options, Reduction& reduction,
                            const Progress& progress = {}, Checkpoint* checkpoint = nullptr);

} // namespace meshbound
