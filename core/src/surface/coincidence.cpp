#include "surface/surface.hpp"

#include <algorithm>
#include <numeric>

namespace meshbound {

void Surface::join_coincident(const std::vector<std::pair<std::uint32_t, std::uint32_t>>& pairs) {
    if (pairs.empty()) return;
    if (representatives_.empty()) {
        representatives_.resize(kind_.size());
        std::iota(representatives_.begin(), representatives_.end(), 0U);
    }
    const auto name = [&](std::uint32_t vertex) {
        while (representatives_[vertex] != vertex)
            vertex = representatives_[vertex] = representatives_[representatives_[vertex]];
        return vertex;
    };
    for (const auto& [a, b] : pairs) {
        const std::uint32_t one = name(a), other = name(b);
        representatives_[std::max(one, other)] = std::min(one, other);
    }
    next_coincident_.assign(kind_.size(), no_index);
    std::vector<std::uint32_t> last(kind_.size(), no_index);
    for (std::uint32_t vertex = 0; vertex < representatives_.size(); ++vertex) {
        const std::uint32_t representative = representatives_[vertex] = name(vertex);
        if (last[representative] != no_index) next_coincident_[last[representative]] = vertex;
        last[representative] = vertex;
    }
}

/// The last half-edge of a boundary vertex's fan that has a triangle.
std::uint32_t Surface::last_in_fan(std::uint32_t vertex) const {
    std::uint32_t last = outgoing_[vertex];
    while (next_spoke(last) != no_index) last = next_spoke(last);
    return last;
}

bool Surface::is_removable(std::uint32_t vertex) const {
    if (kind_[vertex] == VertexKind::absent) return false;
    if (representatives_.empty()) return true;
    std::uint32_t count = 0, lower = no_index, upper = no_index; // the two neighbours on the curve
    bool same_neighbours = true, interior = false;
    for_each_coincident(vertex, [&](std::uint32_t coincident) {
        ++count;
        if (kind_[coincident] != VertexKind::boundary) {
            interior = true;
            return;
        }
        const std::uint32_t one = representative(target(outgoing_[coincident])),
                            other = representative(origin(previous(last_in_fan(coincident))));
        if (lower == no_index) lower = std::min(one, other), upper = std::max(one, other);
        same_neighbours =
            same_neighbours && one != other && lower == std::min(one, other) && upper == std::max(one, other);
    });
    return interior ? count == 1 : same_neighbours;
}

bool Surface::triangle_exists(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
    bool found = false;
    for_each_coincident(a, [&](std::uint32_t coincident) {
        walk_fan(outgoing_[coincident], [&](std::uint32_t spoke) {
            const std::uint32_t one = representative(target(spoke)), other = representative(origin(previous(spoke)));
            found = found || (one == representative(b) && other == representative(c)) ||
                    (one == representative(c) && other == representative(b));
        });
    });
    return found;
}

} // namespace meshbound
