#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "hole.hpp"
#include "rows.hpp"

namespace meshbound {

/// Lays the star out in the plane (§3.2; design: projection first, geodesic polar layout where it folds). The candidate comes
/// to the origin, the ring to `hole.places`, counter-clockwise around it. The layout decides which map is chosen, never
/// whether it is a valid one; so it has no failure.
void lay_out(const Rows& rows, Hole& hole);

/// Twice the signed area of the triangle p, q, r; positive when counter-clockwise.
inline double orientation(const glm::dvec2& p, const glm::dvec2& q, const glm::dvec2& r) {
    return (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
}

/// Sum of the area vectors of the star's triangles: twice its area, along its average normal.
glm::dvec3 star_normal(const Rows& rows, const Hole& hole);

/// Barycentric coordinates of p in the triangle q, r, s, moved into the triangle where they lie outside.
glm::dvec3 clamped_barycentric(const glm::dvec2& p, const glm::dvec2& q, const glm::dvec2& r, const glm::dvec2& s);

} // namespace meshbound
