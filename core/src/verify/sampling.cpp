#include "verify/sampling.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace meshbound::verification {
namespace {

using Triangle = std::array<std::uint32_t, 3>;

/// A new vertex or edge of a triangle: sampled with the first triangle that has it, so that samples come in the order of
/// the triangles and neighbours follow each other.
struct NewParts {
    std::array<bool, 3> vertices{}; ///< corner i
    std::array<bool, 3> edges{};    ///< the edge from corner i to the next
};

std::vector<NewParts> find_new_parts(const JointSurface& surface) {
    std::vector<NewParts> parts(surface.triangles.size());
    std::vector<bool> seen(surface.rows.size() / static_cast<std::size_t>(std::max(1, surface.dimensions)), false);
    std::vector<std::array<std::uint64_t, 2>> edges; // the edge's two vertices, and where it is
    edges.reserve(3 * surface.triangles.size());
    for (std::size_t t = 0; t < surface.triangles.size(); ++t)
        for (int i = 0; i < 3; ++i) {
            const std::uint32_t a = surface.triangles[t][i];
            const std::uint32_t b = surface.triangles[t][(i + 1) % 3];
            parts[t].vertices[i] = !seen[a];
            seen[a] = true;
            if (a != b) edges.push_back({std::uint64_t{std::min(a, b)} << 32 | std::max(a, b), 3 * t + i});
        }
    std::sort(edges.begin(), edges.end());
    for (std::size_t e = 0; e < edges.size(); ++e)
        if (e == 0 || edges[e][0] != edges[e - 1][0]) parts[edges[e][1] / 3].edges[edges[e][1] % 3] = true;
    return parts;
}

double dot_of_edges(const JointSurface& surface, const Triangle& t, int to, int other) {
    const double *a = surface.row(t[0]), *b = surface.row(t[to]), *c = surface.row(t[other]);
    double sum = 0;
    for (int k = 0; k < surface.dimensions; ++k) sum += (b[k] - a[k]) * (c[k] - a[k]);
    return sum;
}

double area(const JointSurface& surface, const Triangle& t) {
    const double cross = dot_of_edges(surface, t, 1, 2);
    const double square = dot_of_edges(surface, t, 1, 1) * dot_of_edges(surface, t, 2, 2) - cross * cross;
    return 0.5 * std::sqrt(std::max(0.0, square));
}

double length(const JointSurface& surface, const Triangle& t, int corner) {
    const double *a = surface.row(t[corner]), *b = surface.row(t[(corner + 1) % 3]);
    double sum = 0;
    for (int k = 0; k < surface.dimensions; ++k) sum += (b[k] - a[k]) * (b[k] - a[k]);
    return std::sqrt(sum);
}

bool is_segment(const Triangle& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; }

/// Samples a unit of joint length, so that all vertices, edges (length / spacing each) and triangles (area / spacing²)
/// together come to the budget; 0 where one sample each already does.
double samples_per_length(const JointSurface& surface, const std::vector<NewParts>& parts, std::size_t budget) {
    double lengths = 0, areas = 0, least = 0;
    for (std::size_t t = 0; t < parts.size(); ++t) {
        for (int i = 0; i < 3; ++i) {
            if (parts[t].edges[i]) lengths += length(surface, surface.triangles[t], i);
            least += parts[t].vertices[i] + parts[t].edges[i];
        }
        areas += area(surface, surface.triangles[t]);
        least += 1;
    }
    const double rest = static_cast<double>(budget) - least;
    if (!(rest > 0) || !(lengths > 0)) return 0;
    // The positive root of areas x² + lengths x = rest, in a form without cancellation.
    return 2 * rest / (lengths + std::sqrt(lengths * lengths + 4 * areas * rest));
}

std::size_t count(double wanted, std::size_t budget) {
    return 1 + static_cast<std::size_t>(std::min(wanted, static_cast<double>(budget)));
}

/// Point i of a sequence that fills a triangle evenly however long it is (Roberts' R2 sequence, folded). The first is
/// the centroid.
std::array<double, 3> inner_point(std::size_t i) {
    constexpr double step_u = 0.7548776662466927, step_v = 0.5698402909980532; // 1/g, 1/g² with g³ = g + 1
    const double n = static_cast<double>(i);
    double u = 1.0 / 3 + n * step_u;
    double v = 1.0 / 3 + n * step_v;
    u -= std::floor(u);
    v -= std::floor(v);
    if (u + v > 1) {
        u = 1 - u;
        v = 1 - v;
    }
    return {1 - u - v, u, v};
}

} // namespace

void sample_surface(const JointSurface& surface, std::size_t budget, const std::function<bool(const Sample&)>& visit) {
    const std::vector<NewParts> parts = find_new_parts(surface);
    const double density = samples_per_length(surface, parts, budget);
    for (std::uint32_t t = 0; t < surface.triangles.size(); ++t) {
        const Triangle& triangle = surface.triangles[t];
        for (int i = 0; i < 3; ++i) {
            Sample corner{t, {}};
            corner.barycentric[i] = 1;
            if (parts[t].vertices[i] && !visit(corner)) return;
            if (!parts[t].edges[i]) continue;
            const std::size_t on_edge = count(density * length(surface, triangle, i), budget);
            for (std::size_t k = 0; k < on_edge; ++k) {
                Sample between{t, {}};
                between.barycentric[(i + 1) % 3] = (static_cast<double>(k) + 0.5) / static_cast<double>(on_edge);
                between.barycentric[i] = 1 - between.barycentric[(i + 1) % 3];
                if (!visit(between)) return;
            }
        }
        if (is_segment(triangle)) continue;
        const std::size_t inside = count(density * density * area(surface, triangle), budget);
        for (std::size_t k = 0; k < inside; ++k)
            if (!visit({t, inner_point(k)})) return;
    }
}

} // namespace meshbound::verification
