#include "errors/tracked/original_edges.hpp"

#include <algorithm>

namespace meshbound {

OriginalEdges::OriginalEdges(const Surface& surface)
    : ends_(2 * surface.edge_count()), start_(surface.vertex_count() + 1, 0) {
    const auto half_edges = static_cast<std::uint32_t>(3 * surface.slot_count());
    const auto for_each_inner = [&](auto&& visit) {
        for (std::uint32_t h = 0; h < half_edges; ++h)
            if (surface.alive(Surface::triangle_of(h)) && surface.twin(h) != no_index && h < surface.twin(h)) visit(h);
    };
    for (std::uint32_t h = 0; h < half_edges; ++h) {
        if (!surface.alive(Surface::triangle_of(h))) continue;
        const std::size_t edge = surface.edge(h);
        ends_[2 * edge] = std::min(surface.origin(h), surface.target(h));
        ends_[2 * edge + 1] = std::max(surface.origin(h), surface.target(h));
    }
    for_each_inner([&](std::uint32_t h) {
        ++start_[surface.origin(h) + std::size_t{1}];
        ++start_[surface.target(h) + std::size_t{1}];
    });
    for (std::size_t v = 0; v + 1 < start_.size(); ++v) start_[v + 1] += start_[v];
    incident_.resize(start_.back() + std::size_t{1});
    std::vector<std::uint32_t> fill(start_.begin(), start_.end() - 1);
    for_each_inner([&](std::uint32_t h) {
        incident_[fill[surface.origin(h)]++] = {surface.edge(h), surface.target(h)};
        incident_[fill[surface.target(h)]++] = {surface.edge(h), surface.origin(h)};
    });
}

} // namespace meshbound
