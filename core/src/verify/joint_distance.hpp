#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace meshbound::verification {

/// The nearest point of a triangle a, b, c: a + u (b - a) + v (c - a).
struct Nearest {
    double distance; ///< attained at (u, v)
    double u, v;
};

/// Distances in the norm of the joint space: Euclidean within each variable, the largest over all variables.
///
/// The nearest point of a triangle minimises the largest of a few convex quadratics of (u, v). It is found by a
/// primal-dual interior-point method. Each set of weights on its way gives a least-squares problem with a closed form,
/// whose value is a lower bound and whose place an upper one: so the result is certified, not hoped for.
class JointDistance {
public:
    static constexpr double accuracy = 1e-7; ///< of a distance, relative where it is above 1
    static constexpr double infinite = 1e300;

    /// `components`: how many numbers of a row belong to each variable.
    explicit JointDistance(std::vector<int> components);

    /// The distance of two points.
    double between(const double* p, const double* q) const;

    /// The variable (its place in `components`) in which they are farthest apart; the first of several.
    std::size_t farthest_variable(const double* p, const double* q) const;

    /// The point of the triangle nearest to `q`, within `accuracy`. Any point no farther than `enough` ends the search.
    /// A triangle that is certainly farther than `cutoff` gives an infinite distance. Where b and c are one row the triangle is
    /// a segment, as a boundary's are.
    Nearest to_triangle(const double* q, const double* a, const double* b, const double* c, double enough = 0,
                        double cutoff = infinite) const;

private:
    /// A place on the triangle, relative to the base of the expansion.
    struct Offset {
        double u, v;
    };
    /// The squared distance in one variable: A u² + 2 B u v + C v² + 2 D u + 2 E v + F.
    struct Quadratic {
        double A = 0, B = 0, C = 0, D = 0, E = 0, F = 0;
        double at(Offset p) const { return (A * p.u + 2 * (B * p.v + D)) * p.u + (C * p.v + 2 * E) * p.v + F; }
        Offset slope(Offset p) const { return {2 * (A * p.u + B * p.v + D), 2 * (B * p.u + C * p.v + E)}; }
        double rounding(Offset p) const;
    };
    struct Triangle {
        const double *q, *a, *b, *c;
    };
    /// Squared distances: attained at the place, and never undercut anywhere on the triangle.
    struct Certified {
        Offset place;
        double upper, lower;
    };
    /// Directions away from the edges u = 0, v = 0, u + v = 1.
    static constexpr std::array<Offset, 3> inward{{{1, 0}, {0, 1}, {-1, -1}}};
    /// The iterate of the interior-point method: a place, a level above all quadratics, and the multipliers of the
    /// triangle's three edges; `slacks` and `weights` (the multipliers of the quadratics) belong to it.
    struct Iterate {
        Offset place;
        double level;
        std::array<double, 3> edges;
    };

    Nearest to_segment(const double* q, const double* a, const double* b) const;
    struct Tangent {
        double square, slope;
    };
    Tangent tangent(const double* q, const double* a, const double* b, double u) const;
    void expand(const Triangle& triangle) const;
    double largest(Offset place) const;
    Offset lowest(const Quadratic& quadratic) const;
    std::array<double, 3> edge_distances(Offset place) const;
    void bracket(Certified& best) const;
    bool decided(const Certified& best) const;
    Certified minimax() const;
    void start(Offset place) const;
    double barrier() const;
    bool newton(double product, Offset& step, double& rise) const;
    bool advance() const;
    double attained(const Triangle& triangle, double u, double v) const;

    std::vector<int> components_;
    int dimensions_ = 0;

    // Working space of one query, kept so that a query allocates nothing.
    mutable Offset base_{};
    mutable double enough_squared_ = 0, cutoff_squared_ = infinite;
    mutable std::vector<Quadratic> quadratics_;
    mutable Iterate iterate_{};
    mutable std::vector<double> weights_, weight_steps_, slacks_, slack_steps_, point_;
};

} // namespace meshbound::verification
