#include "surface/seams.hpp"

#include <algorithm>
#include <array>

#include "mesh/position_at.hpp"

namespace meshbound {
namespace {

/// A boundary edge, from the lexicographically lower to the upper of its two positions.
struct BoundaryEdge {
    std::array<double, 3> from, to;
    std::uint32_t start = no_index, end = no_index; // vertices

    std::pair<const std::array<double, 3>&, const std::array<double, 3>&> positions() const { return {from, to}; }
};

std::array<double, 3> position_of(const Mesh& mesh, const Surface& surface, std::uint32_t vertex) {
    const glm::dvec3 position = position_at(mesh, surface.input(vertex));
    return {position.x, position.y, position.z};
}

} // namespace

std::vector<std::pair<std::uint32_t, std::uint32_t>> find_seams(const Mesh& mesh, const Surface& surface) {
    std::vector<BoundaryEdge> edges;
    for (std::uint32_t h = 0; h < 3 * surface.slot_count(); ++h) {
        if (!surface.alive(Surface::triangle_of(h)) || surface.twin(h) != no_index) continue;
        BoundaryEdge edge{position_of(mesh, surface, surface.origin(h)), position_of(mesh, surface, surface.target(h)),
                          surface.origin(h), surface.target(h)};
        if (edge.from == edge.to) continue;
        if (edge.to < edge.from) {
            std::swap(edge.from, edge.to);
            std::swap(edge.start, edge.end);
        }
        edges.push_back(edge);
    }
    std::sort(edges.begin(), edges.end(), [](const BoundaryEdge& a, const BoundaryEdge& b) {
        return a.positions() != b.positions() ? a.positions() < b.positions() : a.start < b.start;
    });
    std::vector<std::pair<std::uint32_t, std::uint32_t>> seams;
    for (std::size_t i = 1; i < edges.size(); ++i) {
        if (edges[i - 1].positions() != edges[i].positions()) continue;
        if (edges[i - 1].start != edges[i].start) seams.emplace_back(edges[i - 1].start, edges[i].start);
        if (edges[i - 1].end != edges[i].end) seams.emplace_back(edges[i - 1].end, edges[i].end);
    }
    return seams;
}

} // namespace meshbound
