#pragma once

#include <limits>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "errors/tracked/hole_products.hpp"
#include "metric/bounded_rows.hpp"
#include "metric/plane_products.hpp"

namespace meshbound {

/// Nearest points in the joint space of position and variables, all measured in bounds. Distances are sums of squares
/// over all variables: cheap, smooth, and close enough to the largest of the ratios.

/// A squared distance that was summed up from products of this size; 0 where it may be nothing but rounding.
double without_noise(double squared_distance, double products);

/// The x, y ≥ 0 with x + y ≤ 1 where w − x u − y v is shortest: the weights of b and c, where u and v are the edges from a
/// corner a to them, and w leads from a to a point.
glm::dvec2 nearest_in_triangle(const PlaneProducts& products);

/// The triangle of three ring indices of a hole, prepared for finding the points nearest to many inner vertices.
class JointTriangle {
public:
    JointTriangle(const HoleProducts& products, int a, int b, int c);

    /// 1 over the determinant of the products of the edges and over their squares; 0 where a triangle or an edge has no extent.
    struct Inverses {
        double determinant = 0, uu = 0, vv = 0, bc = 0;
    };

    /// The point of the triangle nearest to a vertex.
    struct Nearest {
        glm::dvec3 weight{1, 0, 0}; // barycentric
        double squared_distance = 0;
    };
    /// `along`: the products of the vertex (HoleProducts::vertex). Where the squared distance is not below `limit`, a lower
    /// bound of it that is not either may come instead, with any weight.
    Nearest nearest(const double* along, double limit = std::numeric_limits<double>::infinity()) const;

private:
    int a_, b_, c_, size_;
    double aa_ = 0, au_ = 0, av_ = 0; // dot products of a with itself and with the edges u = b - a and v = c - a
    PlaneProducts edges_;             // uu, uv, vv
    Inverses inverses_;
};

/// The x in [low, high] and y in [0, 1] where w − x u − y v is shortest.
glm::dvec2 nearest_parameters(const PlaneProducts& products, double low, double high);

/// A segment between two rows.
struct JointSegment {
    const double* start;
    const double* end;
};

/// Of two segments: u along the first, v back along the second, and w from the first's start to the second's; so that x and y
/// are the shares of the two along which they are compared.
inline auto between(const JointSegment& first, const JointSegment& second) {
    return [=](int i) -> PlaneLanes {
        const Lane start = BoundedRows::lane(first.start, i), other = BoundedRows::lane(second.start, i);
        return {BoundedRows::lane(first.end, i) - start, other - BoundedRows::lane(second.end, i), other - start};
    };
}

/// A triangle of three rows.
struct JointCorners {
    const double *a, *b, *c;
};

/// Of a triangle and a row: u and v along the edges from a, w from a to the row.
inline auto within(const JointCorners& corners, const double* row) {
    return [=](int i) -> PlaneLanes {
        const Lane a = BoundedRows::lane(corners.a, i);
        return {BoundedRows::lane(corners.b, i) - a, BoundedRows::lane(corners.c, i) - a,
                BoundedRows::lane(row, i) - a};
    };
}

PlaneProducts products_of(const BoundedRows& rows, const JointSegment& first, const JointSegment& second);

} // namespace meshbound
