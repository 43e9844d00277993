#include "surface/surface.hpp"

#include <algorithm>

namespace meshbound {

/// Where labels differ, each side has an edge of its own.
void Surface::cut_region_borders() {
    for (std::uint32_t h = 0; h < origin_.size(); ++h) {
        const std::uint32_t g = twin_[h];
        if (g == no_index || regions_[triangle_of(g)] == regions_[triangle_of(h)]) continue;
        twin_[h] = twin_[g] = no_index;
        edge_[g] = static_cast<std::uint32_t>(edge_count_++);
    }
}

std::uint32_t Surface::fan_length(std::uint32_t start) const {
    std::uint32_t length = 0;
    walk_fan(start, [&](std::uint32_t) { ++length; });
    return length;
}

/// Finds the kind of every vertex and where its fan begins: at a boundary, the half-edge without a twin. Returns how
/// many vertices have several fans.
std::size_t Surface::classify() {
    std::vector<std::uint32_t> valence(kind_.size(), 0);
    std::fill(outgoing_.begin(), outgoing_.end(), no_index);
    for (std::uint32_t h = 0; h < origin_.size(); ++h) {
        const std::uint32_t vertex = origin_[h];
        ++valence[vertex];
        if (outgoing_[vertex] == no_index || twin_[h] == no_index) outgoing_[vertex] = h;
    }
    std::size_t non_manifold = 0;
    for (std::uint32_t vertex = 0; vertex < kind_.size(); ++vertex) {
        if (valence[vertex] == 0) continue;
        const std::uint32_t start = outgoing_[vertex];
        non_manifold += fan_length(start) != valence[vertex];
        kind_[vertex] = twin_[start] == no_index ? VertexKind::boundary : VertexKind::interior;
    }
    return non_manifold;
}

/// In the order of the input vertices and of the half-edges that the fans begin with. A vertex in no triangle has a fan
/// without a half-edge.
std::vector<Surface::Fan> Surface::find_fans() const {
    std::vector<Fan> fans;
    std::vector<char> seen(origin_.size(), 0);
    for (const bool open : {true, false})
        for (std::uint32_t h = 0; h < origin_.size(); ++h) {
            if (seen[h] || (open && twin_[h] != no_index)) continue;
            fans.push_back({origin_[h], h});
            walk_fan(h, [&](std::uint32_t spoke) { seen[spoke] = 1; });
        }
    for (std::uint32_t vertex = 0; vertex < kind_.size(); ++vertex)
        if (kind_[vertex] == VertexKind::absent) fans.push_back({vertex, no_index});
    std::sort(fans.begin(), fans.end(),
              [](const Fan& a, const Fan& b) { return a.input != b.input ? a.input < b.input : a.start < b.start; });
    return fans;
}

/// Gives each fan a vertex of its own; those of one input vertex are a coincidence class.
void Surface::separate_fans() {
    const std::vector<Fan> fans = find_fans();
    first_vertex_.assign(kind_.size(), no_index);
    kind_.assign(fans.size(), VertexKind::absent);
    outgoing_.assign(fans.size(), no_index);
    std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
    for (std::uint32_t vertex = 0; vertex < fans.size(); ++vertex) {
        const auto [input, start] = fans[vertex];
        inputs_.push_back(input);
        if (first_vertex_[input] == no_index) first_vertex_[input] = vertex;
        else pairs.emplace_back(first_vertex_[input], vertex);
        if (start == no_index) continue;
        outgoing_[vertex] = start;
        kind_[vertex] = twin_[start] == no_index ? VertexKind::boundary : VertexKind::interior;
    }
    for (std::uint32_t vertex = 0; vertex < fans.size(); ++vertex)
        if (fans[vertex].start != no_index)
            walk_fan(fans[vertex].start, [&, vertex](std::uint32_t spoke) { origin_[spoke] = vertex; });
    join_coincident(pairs);
}

} // namespace meshbound
