#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include <glm/vec3.hpp>

#include "meshbound/map.hpp"
#include "meshbound/mesh.hpp"

namespace meshbound {

/// Finds triangles of a mesh by their vertices; nowhere if there is none.
class FaceLookup {
public:
    explicit FaceLookup(const Mesh& mesh);

    /// The triangle that has the edge in this direction: the one on its left.
    std::uint32_t left_of(std::uint32_t from, std::uint32_t to) const;
    /// The triangle of three vertices, in this orientation if there is one.
    std::uint32_t of(std::uint32_t a, std::uint32_t b, std::uint32_t c) const;

    /// Whether sheets meet at an edge: three or more triangles, two with opposite orientations or two of different
    /// regions. A point on it is in a triangle of each sheet.
    bool is_curve(std::uint32_t a, std::uint32_t b) const;

    /// The label of a triangle; 0 where there are none.
    std::int32_t region(std::uint32_t triangle) const { return regions_->empty() ? 0 : (*regions_)[triangle]; }

private:
    std::size_t count(std::uint32_t from, std::uint32_t to) const;
    std::uint32_t oriented(std::uint32_t a, std::uint32_t b, std::uint32_t c) const;

    const std::vector<glm::uvec3>* triangles_;
    const std::vector<std::int32_t>* regions_;
    std::vector<std::pair<std::uint64_t, std::uint32_t>> half_edges_; // sorted: ends, triangle
};

} // namespace meshbound
