#include "segmentation/face_lookup.hpp"

#include <algorithm>

namespace meshbound {
namespace {

std::uint64_t half_edge(std::uint32_t from, std::uint32_t to) { return std::uint64_t{from} << 32 | to; }

bool has_corner(const glm::uvec3& triangle, std::uint32_t vertex) {
    return triangle.x == vertex || triangle.y == vertex || triangle.z == vertex;
}

} // namespace

FaceLookup::FaceLookup(const Mesh& mesh) : triangles_(&mesh.triangles), regions_(&mesh.regions) {
    const std::vector<glm::uvec3>& triangles = mesh.triangles;
    half_edges_.reserve(3 * triangles.size());
    for (std::uint32_t n = 0; n < triangles.size(); ++n)
        for (int i = 0; i < 3; ++i) half_edges_.emplace_back(half_edge(triangles[n][i], triangles[n][(i + 1) % 3]), n);
    std::sort(half_edges_.begin(), half_edges_.end());
}

std::size_t FaceLookup::count(std::uint32_t from, std::uint32_t to) const {
    const std::uint64_t ends = half_edge(from, to);
    const auto first = std::lower_bound(half_edges_.begin(), half_edges_.end(), std::pair{ends, std::uint32_t{0}});
    auto last = first;
    while (last != half_edges_.end() && last->first == ends) ++last;
    return static_cast<std::size_t>(last - first);
}

bool FaceLookup::is_curve(std::uint32_t a, std::uint32_t b) const {
    const std::size_t one = count(a, b), other = count(b, a);
    if (one + other < 2) return false;
    if (one != 1 || other != 1) return true;
    return !regions_->empty() && (*regions_)[left_of(a, b)] != (*regions_)[left_of(b, a)];
}

std::uint32_t FaceLookup::left_of(std::uint32_t from, std::uint32_t to) const {
    const std::uint64_t ends = half_edge(from, to);
    const auto found = std::lower_bound(half_edges_.begin(), half_edges_.end(), std::pair{ends, std::uint32_t{0}});
    return found != half_edges_.end() && found->first == ends ? found->second : nowhere;
}

std::uint32_t FaceLookup::oriented(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
    const std::uint64_t ends = half_edge(a, b);
    auto found = std::lower_bound(half_edges_.begin(), half_edges_.end(), std::pair{ends, std::uint32_t{0}});
    for (; found != half_edges_.end() && found->first == ends; ++found)
        if (has_corner((*triangles_)[found->second], c)) return found->second;
    return nowhere;
}

std::uint32_t FaceLookup::of(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
    const std::uint32_t same = oriented(a, b, c);
    return same != nowhere ? same : oriented(b, a, c);
}

} // namespace meshbound
