#pragma once

#include <cstdint>
#include <vector>

#include "meshbound/mesh.hpp"
#include "meshbound/report.hpp"

namespace meshbound {

/// A surface on the way of a reduction, from which another one can go on (see resume_reduction): what is left of the original,
/// and how far from it that may lie by now. The result of a reduction is one too: {reduction.mesh, reduction.vertices,
/// reduction.report}.
struct Checkpoint {
    Mesh mesh;
    std::vector<std::uint32_t> vertices; ///< for each of its vertices the index in the original, rising
    /// Of the original, and of what was *spent*: VariableReport::error, which no point of the surface exceeds, in the unit of
    /// the variable, NaN where it is not known; such a variable stays free. Bounds are those that the reduction was asked for;
    /// it counts no refusals and no turned triangles.
    Report report;
};

} // namespace meshbound
