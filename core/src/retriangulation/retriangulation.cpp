#include "retriangulation/retriangulation.hpp"

#include <algorithm>
#include <limits>

#include <glm/geometric.hpp>

#include "retriangulation/ring_triangle.hpp"
#include "util/indexing.hpp"

namespace meshbound {
namespace {

constexpr double impossible = std::numeric_limits<double>::infinity();

/// Weight of the shape penalty beside the squared errors (1 is the bound): large enough to decide between
/// retriangulations with equal errors, small enough never to trade a noticeable error for a better shape.
constexpr double shape_weight = 1e-6;

/// 1 for the equilateral triangle, larger for needles; bounded, so that a degenerate triangle can still be chosen.
double shape_penalty(const RingTriangle& triangle) {
    const double edges =
        glm::dot(triangle.u, triangle.u) + glm::dot(triangle.v, triangle.v) + glm::dot(triangle.w, triangle.w);
    constexpr double worst = 1e3, equilateral = 3.4641016151377544; // 2 √3: edges / area of the equilateral triangle
    const double area = equilateral * triangle.length;
    return edges < worst * area ? edges / area : worst;
}

} // namespace

/// The cheapest triangulation of the sub-polygon a … b: a triangle on (a, b) and those of the two sub-polygons that it
/// leaves.
void Retriangulator::fill(const Hole& hole, const Legality& legality, HoleCost& cost, int a, int b) {
    const int size = hole.size();
    double& best = cost_[to_index(a * size + b)];
    for (int m = a + 1; m < b; ++m) {
        const double sub_costs = cost_[to_index(a * size + m)] + cost_[to_index(m * size + b)];
        if (!(sub_costs < best) || !legality.is_ccw_in_layout(a, m, b)) continue;
        const RingTriangle triangle(hole, a, m, b);
        if (!legality.allows_triangle(triangle)) continue;
        const double shaped = sub_costs + shape_weight * shape_penalty(triangle);
        if (!(shaped < best)) continue; // costs are never negative
        const double limit = best - shaped, own = cost.triangle(a, m, b, limit);
        if (!(own < limit)) continue; // but a lower bound, which rounding could bring below the best when it is added
        const double total = shaped + own;
        if (!(total < best)) continue;
        if (!legality.allows_neighbours(triangle, normal_across(size, a, m), normal_across(size, m, b))) continue;
        best = total;
        middle_[to_index(a * size + b)] = m;
        normal_[to_index(a * size + b)] = triangle.normal;
    }
}

void Retriangulator::solve(const Hole& hole, const Legality& legality, HoleCost& cost) {
    const int size = hole.size();
    cost_.assign(to_index(size * size), impossible);
    middle_.assign(to_index(size * size), -1);
    normal_.resize(to_index(size * size));
    for (int a = 0; a + 1 < size; ++a) cost_[to_index(a * size + a + 1)] = 0;
    for (int span = 2; span < size; ++span) {
        for (int a = 0; a + span < size; ++a) {
            const int b = a + span;
            if (!legality.allows_edge(a, b)) continue;
            fill(hole, legality, cost, a, b);
            double& best = cost_[to_index(a * size + b)];
            if (span < size - 1 && best < impossible) best += cost.diagonal(a, b);
        }
    }
}

/// Builds the tree of triangles from the table of middle corners, root first.
void Retriangulator::build_tree(int size, Retriangulation& best) const {
    std::vector<NewTriangle>& triangles = best.triangles;
    triangles.clear();
    triangles.push_back({0, middle_[to_index(size - 1)], size - 1});
    for (std::size_t n = 0; n < triangles.size(); ++n) {
        const auto grow = [&](int a, int b) {
            if (b == a + 1) return -1;
            NewTriangle child{a, middle_[to_index(a * size + b)], b};
            child.parent = static_cast<int>(n);
            triangles.push_back(child);
            return static_cast<int>(triangles.size() - 1);
        };
        const int a = triangles[n].a, m = triangles[n].m, b = triangles[n].b;
        const int left = grow(a, m), right = grow(m, b);
        triangles[n].left = left;
        triangles[n].right = right;
    }
}

bool Retriangulator::triangulate(const Hole& hole, Legality& legality, HoleCost& cost, Retriangulation& best) {
    do {
        solve(hole, legality, cost);
        if (!(cost_[to_index(hole.size() - 1)] < impossible)) return false;
        build_tree(hole.size(), best);
    } while (!legality.allows_diagonals(best));
    return true;
}

bool Retriangulator::fan(const Hole& hole, Legality& legality, int hub, Retriangulation& best) {
    const int size = hole.size();
    middle_.assign(to_index(size * size), -1);
    normal_.resize(to_index(size * size));
    for (int a = 0; a + 1 < hub; ++a) middle_[to_index(a * size + hub)] = a + 1;
    for (int b = hub + 2; b < size; ++b) middle_[to_index(hub * size + b)] = b - 1;
    if (hub > 0 && hub < size - 1) middle_[to_index(size - 1)] = hub;
    build_tree(size, best);
    const auto is_legal = [&](const NewTriangle& triangle) {
        const int a = triangle.a, m = triangle.m, b = triangle.b;
        if (!legality.allows_edge(a, b) || !legality.is_ccw_in_layout(a, m, b)) return false;
        const RingTriangle in_space(hole, a, m, b);
        normal_[to_index(a * size + b)] = in_space.normal;
        return legality.allows_triangle(in_space) &&
               legality.allows_neighbours(in_space, normal_across(size, a, m), normal_across(size, m, b));
    };
    const auto& triangles = best.triangles; // children before parents, whose neighbours they are
    return std::all_of(triangles.rbegin(), triangles.rend(), is_legal) && legality.allows_diagonals(best);
}

/// The normal of the triangle chosen beyond (a, b); null for a link edge.
const glm::dvec3* Retriangulator::normal_across(int size, int a, int b) const {
    return b == a + 1 ? nullptr : &normal_[to_index(a * size + b)];
}

} // namespace meshbound
