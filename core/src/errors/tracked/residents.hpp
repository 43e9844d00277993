#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

#include "util/fetch.hpp"
#include "surface/surface.hpp"

namespace meshbound {

/// Where the map has put the removed vertices: an interior one lies in a current triangle, a boundary one on a current
/// boundary edge. Each host, triangle or edge, chains its residents.
class Residents {
public:
    explicit Residents(const Surface& surface)
        : in_triangle_(surface.slot_count(), no_index),
          on_edge_(surface.is_closed() ? 0 : surface.edge_count(), no_index), next_(surface.vertex_count(), no_index),
          places_(surface.vertex_count()) {}

    std::uint32_t in_triangle(std::uint32_t slot) const { return in_triangle_[slot]; }
    std::uint32_t on_edge(std::uint32_t edge) const { return on_edge_.empty() ? no_index : on_edge_[edge]; }
    /// The next resident of the same host, or no_index.
    std::uint32_t next(std::uint32_t vertex) const { return next_[vertex]; }

    /// Barycentric coordinates of a resident in its triangle, by the corners' half-edges 3 slot, 3 slot + 1, 3 slot + 2.
    glm::dvec3 barycentric(std::uint32_t vertex) const {
        const Place& place = places_[vertex];
        return {std::max(0.0, 1 - place.x - place.y), place.x, place.y};
    }
    /// Has the processor fetch where a resident lies, without waiting.
    void fetch_place(std::uint32_t vertex) const { fetch(&places_[vertex]); }
    /// Share along its boundary edge, from the edge's lower vertex.
    double share(std::uint32_t vertex) const { return places_[vertex].x; }

    void clear_triangle(std::uint32_t slot) { in_triangle_[slot] = no_index; }
    void clear_edge(std::uint32_t edge) {
        if (!on_edge_.empty()) on_edge_[edge] = no_index;
    }

    void settle_in_triangle(std::uint32_t vertex, std::uint32_t slot, const glm::dvec3& barycentric) {
        places_[vertex] = {barycentric.y, barycentric.z};
        next_[vertex] = in_triangle_[slot];
        in_triangle_[slot] = vertex;
    }
    void settle_on_edge(std::uint32_t vertex, std::uint32_t edge, double share) {
        places_[vertex] = {share, 0};
        next_[vertex] = on_edge_[edge];
        on_edge_[edge] = vertex;
    }

private:
    struct Place {
        double x = 0, y = 0;
    };
    std::vector<std::uint32_t> in_triangle_, on_edge_; // the first resident; of closed surfaces none is on an edge
    std::vector<std::uint32_t> next_;                  // by vertex
    std::vector<Place> places_;                        // by vertex
};

} // namespace meshbound
