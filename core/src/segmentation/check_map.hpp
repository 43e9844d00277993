#pragma once

#include "meshbound/mapped_surfaces.hpp"
#include "meshbound/segmentation.hpp"
#include "meshbound/status.hpp"

namespace meshbound {

/// Barycentric coordinates add up to 1 but for the rounding of a few products; those of a point in another triangle
/// miss it by the weight of a corner.
inline constexpr double rounding_of_shares = 1e-9;

/// Whether both surfaces are valid, and whatever the map between them names is there: triangles, vertices, edges that
/// are crossed, and points on them. Whether its cells fit, too, is found out when they are cut. Faults: those of
/// validate; bad_map, with the vertex of the original or of the reduced mesh, the triangle of the original or the
/// crossing at fault.
Status check_map(const MappedSurfaces& surfaces);

/// Whether each crossing is a corner of the segmentation that the map led to. Fault: bad_map, with the crossing.
Status check_crossings_met(const MappedSurfaces& surfaces, const Segmentation& segmentation);

/// Whether both surfaces carry the same variables, in the same precision. Fault: bad_map, with the variable.
Status check_same_variables(const MappedSurfaces& surfaces);

} // namespace meshbound
