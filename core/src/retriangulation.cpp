#include "retriangulation.hpp"

#include <algorithm>
#include <limits>

#include <glm/geometric.hpp>

namespace meshbound {
namespace {

constexpr double impossible = std::numeric_limits<double>::infinity();

/// Weight of shape beside the squared errors (1 is the bound): large enough to part retriangulations whose errors are alike,
/// small enough never to buy a shape with an error that counts.
constexpr double shape_weight = 1e-6;

/// 1 for the equilateral triangle, growing with every needle; bounded so that a degenerate one can still be chosen.
double shapelessness(const glm::dvec3& p, const glm::dvec3& q, const glm::dvec3& r) {
    const glm::dvec3 u = q - p, v = r - p, w = r - q;
    const double edges = glm::dot(u, u) + glm::dot(v, v) + glm::dot(w, w);
    const double area = glm::length(glm::cross(u, v));
    constexpr double worst = 1e3, equilateral = 3.4641016151377544; // 2 √3: edges / area of the equilateral triangle
    return edges < worst * equilateral * area ? edges / (equilateral * area) : worst;
}

std::size_t at(int i) { return static_cast<std::size_t>(i); }

} // namespace

void Retriangulator::solve(const Rows& rows, const Hole& hole, const Legality& legality, HoleCost& cost) {
    const int size = hole.size();
    cost_.assign(at(size * size), impossible);
    middle_.assign(at(size * size), -1);
    for (int a = 0; a + 1 < size; ++a) cost_[at(a * size + a + 1)] = 0;
    const auto position = [&](int i) { return rows.position(hole.ring[at(i)]); };
    for (int span = 2; span < size; ++span) {
        for (int a = 0; a + span < size; ++a) {
            const int b = a + span;
            if (!legality.allows_edge(a, b)) continue;
            double& best = cost_[at(a * size + b)];
            for (int m = a + 1; m < b; ++m) {
                const double parts = cost_[at(a * size + m)] + cost_[at(m * size + b)];
                if (!(parts < best) || !legality.allows_triangle(a, m, b)) continue;
                const double total = parts + cost.triangle(a, m, b) +
                                     shape_weight * shapelessness(position(a), position(m), position(b));
                if (!(total < best)) continue;
                if (!legality.allows_neighbours(a, m, b, middle_[at(a * size + m)], middle_[at(m * size + b)]))
                    continue;
                best = total;
                middle_[at(a * size + b)] = m;
            }
            if (span < size - 1 && best < impossible) best += cost.diagonal(a, b);
        }
    }
}

/// The tree of triangles from the table of middles, root first.
void Retriangulator::unfold(int size, Retriangulation& best) const {
    std::vector<NewTriangle>& triangles = best.triangles;
    triangles.clear();
    triangles.push_back({0, middle_[at(size - 1)], size - 1});
    for (std::size_t n = 0; n < triangles.size(); ++n) {
        const auto grow = [&](int a, int b) {
            if (b == a + 1) return -1;
            NewTriangle child{a, middle_[at(a * size + b)], b};
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

bool Retriangulator::triangulate(const Rows& rows, const Hole& hole, const Legality& legality, HoleCost& cost,
                                 Retriangulation& best) {
    solve(rows, hole, legality, cost);
    if (!(cost_[at(hole.size() - 1)] < impossible)) return false;
    unfold(hole.size(), best);
    return true;
}

bool Retriangulator::fan(const Hole& hole, const Legality& legality, int hub, Retriangulation& best) {
    const int size = hole.size();
    middle_.assign(at(size * size), -1);
    for (int a = 0; a + 1 < hub; ++a) middle_[at(a * size + hub)] = a + 1;
    for (int b = hub + 2; b < size; ++b) middle_[at(hub * size + b)] = b - 1;
    if (hub > 0 && hub < size - 1) middle_[at(size - 1)] = hub;
    unfold(size, best);
    const auto third = [&](int a, int b) { return middle_[at(a * size + b)]; };
    return std::all_of(best.triangles.begin(), best.triangles.end(), [&](const NewTriangle& triangle) {
        const int a = triangle.a, m = triangle.m, b = triangle.b;
        return legality.allows_edge(a, b) && legality.allows_triangle(a, m, b) &&
               legality.allows_neighbours(a, m, b, third(a, m), third(m, b));
    });
}

} // namespace meshbound
