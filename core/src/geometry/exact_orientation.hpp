#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace meshbound {

/// On which side of the plane through a, b and c the point d lies: 1 where a, b, c run counter-clockwise seen from d, -1 on
/// the other side, 0 in the plane. Never wrong (see Expansion for what "exact" supposes).
int exact_orientation(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, const glm::dvec3& d);

/// How the triangle p, q, r runs: 1 counter-clockwise, -1 clockwise, 0 where the three lie on a line. Never wrong.
int exact_orientation(const glm::dvec2& p, const glm::dvec2& q, const glm::dvec2& r);

} // namespace meshbound
