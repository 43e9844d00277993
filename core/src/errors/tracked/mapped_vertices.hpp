#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

#include "surface/surface.hpp"
#include "util/prefetch.hpp"

namespace meshbound {

/// The images of the removed vertices under the map: of an interior vertex a point in a current triangle, of a boundary
/// vertex one on a current boundary edge. Each container, a triangle or an edge, has a linked list of the vertices
/// mapped into it.
class MappedVertices {
public:
    explicit MappedVertices(const Surface& surface)
        : in_triangle_(surface.slot_count(), no_index),
          on_edge_(surface.is_closed() ? 0 : surface.edge_count(), no_index), next_(surface.vertex_count(), no_index),
          coordinates_(surface.vertex_count()) {}

    std::uint32_t in_triangle(std::uint32_t slot) const { return in_triangle_[slot]; }
    std::uint32_t on_edge(std::uint32_t edge) const { return on_edge_.empty() ? no_index : on_edge_[edge]; }
    /// The next vertex in the same container, or no_index.
    std::uint32_t next(std::uint32_t vertex) const { return next_[vertex]; }

    /// Barycentric coordinates of a vertex in its triangle, by the corners' half-edges 3 slot, 3 slot + 1, 3 slot + 2.
    glm::dvec3 barycentric(std::uint32_t vertex) const {
        const Coordinates& coordinates = coordinates_[vertex];
        return {std::max(0.0, 1 - coordinates.x - coordinates.y), coordinates.x, coordinates.y};
    }
    /// Prefetches the coordinates of a vertex.
    void prefetch_coordinates(std::uint32_t vertex) const { prefetch(&coordinates_[vertex]); }
    /// Share along its boundary edge, from the edge's lower vertex.
    double share(std::uint32_t vertex) const { return coordinates_[vertex].x; }

    void clear_triangle(std::uint32_t slot) { in_triangle_[slot] = no_index; }
    void clear_edge(std::uint32_t edge) {
        if (!on_edge_.empty()) on_edge_[edge] = no_index;
    }

    void put_in_triangle(std::uint32_t vertex, std::uint32_t slot, const glm::dvec3& barycentric) {
        coordinates_[vertex] = {barycentric.y, barycentric.z};
        next_[vertex] = in_triangle_[slot];
        in_triangle_[slot] = vertex;
    }
    void put_on_edge(std::uint32_t vertex, std::uint32_t edge, double share) {
        coordinates_[vertex] = {share, 0};
        next_[vertex] = on_edge_[edge];
        on_edge_[edge] = vertex;
    }

private:
    struct Coordinates {
        double x = 0, y = 0;
    };
    std::vector<std::uint32_t> in_triangle_, on_edge_; // the first vertex; on closed surfaces none is on an edge
    std::vector<std::uint32_t> next_;                  // by vertex
    std::vector<Coordinates> coordinates_;             // by vertex
};

} // namespace meshbound
