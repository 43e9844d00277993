#include "surface/surface.hpp"

#include <algorithm>
#include <numeric>

namespace meshbound {

void Surface::join_sites(const std::vector<std::pair<std::uint32_t, std::uint32_t>>& pairs) {
    if (pairs.empty()) return;
    if (sites_.empty()) {
        sites_.resize(kind_.size());
        std::iota(sites_.begin(), sites_.end(), 0U);
    }
    const auto name = [&](std::uint32_t vertex) {
        while (sites_[vertex] != vertex) vertex = sites_[vertex] = sites_[sites_[vertex]];
        return vertex;
    };
    for (const auto& [a, b] : pairs) {
        const std::uint32_t one = name(a), other = name(b);
        sites_[std::max(one, other)] = std::min(one, other);
    }
    next_in_site_.assign(kind_.size(), no_index);
    std::vector<std::uint32_t> last(kind_.size(), no_index);
    for (std::uint32_t vertex = 0; vertex < sites_.size(); ++vertex) {
        const std::uint32_t site = sites_[vertex] = name(vertex);
        if (last[site] != no_index) next_in_site_[last[site]] = vertex;
        last[site] = vertex;
    }
}

/// The spoke of a boundary vertex's last triangle, behind which its fan ends.
std::uint32_t Surface::last_in_fan(std::uint32_t vertex) const {
    std::uint32_t last = outgoing_[vertex];
    while (next_spoke(last) != no_index) last = next_spoke(last);
    return last;
}

bool Surface::is_free(std::uint32_t vertex) const {
    if (kind_[vertex] == VertexKind::absent) return false;
    if (sites_.empty()) return true;
    std::uint32_t copies = 0, lower = no_index, upper = no_index; // the two neighbours on the curve
    bool alike = true, interior = false;
    for_each_in_site(vertex, [&](std::uint32_t copy) {
        ++copies;
        if (kind_[copy] != VertexKind::boundary) {
            interior = true;
            return;
        }
        const std::uint32_t one = site(target(outgoing_[copy])), other = site(origin(previous(last_in_fan(copy))));
        if (lower == no_index) lower = std::min(one, other), upper = std::max(one, other);
        alike = alike && one != other && lower == std::min(one, other) && upper == std::max(one, other);
    });
    return interior ? copies == 1 : alike;
}

bool Surface::triangle_exists(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
    bool found = false;
    for_each_in_site(a, [&](std::uint32_t copy) {
        walk_fan(outgoing_[copy], [&](std::uint32_t spoke) {
            const std::uint32_t one = site(target(spoke)), other = site(origin(previous(spoke)));
            found = found || (one == site(b) && other == site(c)) || (one == site(c) && other == site(b));
        });
    });
    return found;
}

} // namespace meshbound
