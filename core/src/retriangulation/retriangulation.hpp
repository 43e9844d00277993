#pragma once

#include <vector>

#include "retriangulation/legality.hpp"
#include "surface/hole.hpp"

namespace meshbound {

/// The cost of a retriangulation (§3.4.1): a sum over its diagonals and triangles, none of which is negative.
class HoleCost {
public:
    virtual ~HoleCost() = default;
    /// Cost of the diagonal between ring indices i < j.
    virtual double diagonal(int i, int j) = 0;
    /// Cost of the triangle of ring indices a < m < b; may stop early, with a lower bound of it that is not below
    /// `limit`.
    virtual double triangle(int a, int m, int b, double limit) = 0;
};

/// Finds the cheapest legal triangulation of a hole, by dynamic programming over the polygon: O(k³) triangles for k
/// corners. It takes the place of the greedy start and edge flips of §3.4. Folds between neighbours are checked against
/// the cheapest triangulations of sub-polygons only, so they are no part of the optimum.
class Retriangulator {
public:
    /// Fills `best`; false where no legal triangulation exists.
    bool triangulate(const Hole& hole, Legality& legality, HoleCost& cost, Retriangulation& best);

    /// The triangulation whose triangles all meet at ring index `hub`; false where it is not legal.
    bool fan(const Hole& hole, Legality& legality, int hub, Retriangulation& best);

private:
    void solve(const Hole& hole, const Legality& legality, HoleCost& cost);
    void fill(const Hole& hole, const Legality& legality, HoleCost& cost, int a, int b);
    void build_tree(int size, Retriangulation& best) const;
    const glm::dvec3* normal_across(int size, int a, int b) const;

    std::vector<double> cost_;       // [a * size + b]: cheapest filling of the sub-polygon a … b
    std::vector<int> middle_;        // the third corner of its triangle on (a, b); -1: none is legal
    std::vector<glm::dvec3> normal_; // and the normal of that triangle, where there is one
};

} // namespace meshbound
