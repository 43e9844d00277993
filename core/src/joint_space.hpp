#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "hole_products.hpp"
#include "measured_rows.hpp"

namespace meshbound {

/// Nearest places in the joint space of position and variables, all measured in bounds (design: the freedom of Φ). Sums of
/// squares: cheap, smooth, and close enough to the largest of the ratios.

/// A squared distance that was summed up from products of this size; 0 where rounding may have made it.
double without_noise(double squared_distance, double products);

/// The triangle of three ring positions of a hole, prepared for looking up many of its inner vertices.
class JointTriangle {
public:
    JointTriangle(const HoleProducts& products, int a, int b, int c);

    /// The point of the triangle nearest to a vertex.
    struct Nearest {
        glm::dvec3 weight{1, 0, 0}; // barycentric
        double squared_distance = 0;
    };
    /// `along`: the products of the vertex (HoleProducts::vertex).
    Nearest nearest(const double* along) const;

private:
    glm::dvec2 nearest_on_edges(double p, double q) const;
    double squared_distance(const glm::dvec2& place, double p, double q) const;

    int a_, b_, c_, size_;
    double aa_ = 0, au_ = 0, av_ = 0; // dot products of a with itself and with the edges u = b - a and v = c - a
    double uu_ = 0, uv_ = 0, vv_ = 0; // of the edges
    double inverse_determinant_ = 0;  // of the edges' products; 0: the triangle has no area
};

/// What two segments' nearest places follow from: dot products of the first, u, the second, v, and w, from the first's start
/// to the second's.
struct SegmentProducts {
    double uu = 0, uv = 0, vv = 0, uw = 0, vw = 0;
};

/// The parameters (s on the first, t on the second) where two segments are nearest to each other, s in [s_low, s_high] and t
/// in [0, 1].
glm::dvec2 nearest_parameters(const SegmentProducts& products, double s_low, double s_high);

/// A segment between two rows.
struct JointSegment {
    const double* start;
    const double* end;
};

SegmentProducts products_of(const MeasuredRows& rows, const JointSegment& first, const JointSegment& second);

} // namespace meshbound
