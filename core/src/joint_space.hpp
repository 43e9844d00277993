#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "measured_rows.hpp"

namespace meshbound {

/// Nearest places in the joint space of position and variables, all measured in bounds (design: the freedom of Φ). Sums of
/// squares: cheap, smooth, and close enough to the largest of the ratios.

/// The triangle of three rows, prepared for looking up many points.
class JointTriangle {
public:
    JointTriangle(const MeasuredRows& rows, const double* a, const double* b, const double* c);

    /// Barycentric coordinates of the point of the triangle nearest to a row.
    glm::dvec3 nearest(const MeasuredRows& rows, const double* row) const {
        Lane p = {0, 0}, q = {0, 0};
        for (int i = 0; i < rows.lanes(); ++i) {
            const Lane a = MeasuredRows::lane(a_, i), d = MeasuredRows::lane(row, i) - a;
            p += d * (MeasuredRows::lane(b_, i) - a);
            q += d * (MeasuredRows::lane(c_, i) - a);
        }
        return nearest(p[0] + p[1], q[0] + q[1]);
    }

    const double* a() const { return a_; }
    const double* b() const { return b_; }
    const double* c() const { return c_; }

    /// Largest squared ratio between a row and the triangle's point at barycentric coordinates w.
    double squared_ratio(const MeasuredRows& rows, const double* row, const glm::dvec3& w) const {
        return rows.squared_ratio(row, a_, b_, c_, w.x, w.y, w.z);
    }

private:
    glm::dvec3 nearest(double p, double q) const;
    glm::dvec2 nearest_on_edges(double p, double q) const;

    const double *a_, *b_, *c_;
    double uu_ = 0, uv_ = 0, vv_ = 0; // dot products of the edges u = b - a and v = c - a
};

/// A segment between two rows.
struct JointSegment {
    const double* start;
    const double* end;
};

/// The parameters (s on the first, t on the second) where two segments are nearest to each other, s in [s_low, s_high] and t
/// in [0, 1].
glm::dvec2 nearest_parameters(const MeasuredRows& rows, const JointSegment& first, double s_low, double s_high,
                              const JointSegment& second);

} // namespace meshbound
