#include "surface/hole.hpp"

namespace meshbound {

void gather_star(const Surface& surface, std::uint32_t candidate, Hole& hole) {
    hole.candidate = candidate;
    hole.open = surface.kind(candidate) == VertexKind::boundary;
    hole.ring.clear();
    hole.spoke_edges.clear();
    hole.slots.clear();
    hole.link_half_edges.clear();
    hole.link_edges.clear();
    const std::uint32_t first = surface.outgoing(candidate);
    std::uint32_t spoke = first, last = first;
    do {
        hole.ring.push_back(surface.target(spoke));
        hole.spoke_edges.push_back(surface.edge(spoke));
        hole.slots.push_back(Surface::triangle_of(spoke));
        hole.link_half_edges.push_back(Surface::next(spoke));
        hole.link_edges.push_back(surface.edge(Surface::next(spoke)));
        last = spoke;
        spoke = surface.next_spoke(spoke);
    } while (spoke != no_index && spoke != first);
    if (!hole.open) return;
    const std::uint32_t arriving = Surface::previous(last);
    hole.ring.push_back(surface.origin(arriving));
    hole.spoke_edges.push_back(surface.edge(arriving));
}

} // namespace meshbound
