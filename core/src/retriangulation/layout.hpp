#pragma once

#include <glm/vec3.hpp>

#include "metric/rows.hpp"
#include "surface/hole.hpp"

namespace meshbound {

/// Lays the star out in the plane (§3.2): by projection, or by the geodesic polar map where that folds. The candidate
/// comes to the origin, the ring to `hole.layout`, counter-clockwise around it; fills `hole.positions` and
/// `hole.spokes`, too. The layout decides which map is chosen, never whether it is a valid one; so it cannot fail.
void lay_out(const Rows& rows, Hole& hole);

/// Sum of the area vectors of the laid-out star's triangles: twice its area, along its average normal.
glm::dvec3 star_normal(const Hole& hole);

} // namespace meshbound
