#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "rows.hpp"

namespace meshbound {

/// Nearest places in the joint space of position and variables, all measured in bounds (design: the freedom of Φ). Free
/// variables do not count. Sums of squares: cheap, smooth, and close enough to the largest of the ratios.

/// The triangle of three rows, prepared for looking up many points.
class JointTriangle {
public:
    JointTriangle() = default;
    JointTriangle(const Rows& rows, const double* a, const double* b, const double* c);

    /// Barycentric coordinates of the point of the triangle nearest to a row.
    glm::dvec3 nearest(const double* row) const;

private:
    glm::dvec2 nearest_on_edges(double p, double q) const;

    const Rows* rows_ = nullptr;
    const double *a_ = nullptr, *b_ = nullptr, *c_ = nullptr;
    double uu_ = 0, uv_ = 0, vv_ = 0; // dot products of the edges u = b - a and v = c - a
};

/// A segment between two rows.
struct JointSegment {
    const double* start;
    const double* end;
};

/// The parameters (s on the first, t on the second) where two segments are nearest to each other, s in [s_low, s_high] and t
/// in [0, 1].
glm::dvec2 nearest_parameters(const Rows& rows, const JointSegment& first, double s_low, double s_high,
                              const JointSegment& second);

} // namespace meshbound
