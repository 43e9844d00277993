#pragma once

#include <glm/vec3.hpp>

#include "surface/hole.hpp"
#include "metric/rows.hpp"

namespace meshbound {

/// Lays the star out in the plane (§3.2; design: projection first, geodesic polar layout where it folds). The candidate comes
/// to the origin, the ring to `hole.places`, counter-clockwise around it; `hole.spokes` is what is laid out. The layout decides which map is chosen, never
/// whether it is a valid one; so it has no failure.
void lay_out(const Rows& rows, Hole& hole);

/// Sum of the area vectors of the laid-out star's triangles: twice its area, along its average normal.
glm::dvec3 star_normal(const Hole& hole);

} // namespace meshbound
