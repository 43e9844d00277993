#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

namespace meshbound {

/// The half-edges of a mesh, grouped by the undirected edges that they belong to. Half-edge 3t + i runs from corner i
/// of triangle t to the next one.
class HalfEdgesByEdge {
public:
    /// `origin`: by half-edge, the vertex where it begins.
    HalfEdgesByEdge(const std::vector<std::uint32_t>& origin, std::size_t vertices)
        : origin_(origin), start_(vertices + 1, 0), sorted_(origin.size()) {
        const auto half_edges = static_cast<std::uint32_t>(origin.size());
        for (std::uint32_t h = 0; h < half_edges; ++h) ++start_[lower(h) + std::size_t{1}];
        for (std::size_t v = 0; v < vertices; ++v) start_[v + 1] += start_[v];
        std::vector<std::uint32_t> fill(start_.begin(), start_.end() - 1);
        for (std::uint32_t h = 0; h < half_edges; ++h) sorted_[fill[lower(h)]++] = h;
    }

    /// Calls `visit(first, count)` for each edge with its half-edges, rising, in the order of the edges' lower and
    /// upper vertices. To be called once: it sorts in place.
    template <class Visit>
    void for_each_edge(const Visit& visit) {
        for (std::size_t v = 0; v + 1 < start_.size(); ++v) {
            const auto first = sorted_.begin() + start_[v], last = sorted_.begin() + start_[v + 1];
            std::sort(first, last, [&](std::uint32_t g, std::uint32_t h) {
                return upper(g) != upper(h) ? upper(g) < upper(h) : g < h;
            });
            for (auto run = first; run != last;) {
                auto end = run + 1;
                while (end != last && upper(*end) == upper(*run)) ++end;
                visit(&*run, static_cast<std::size_t>(end - run));
                run = end;
            }
        }
    }

private:
    std::uint32_t target(std::uint32_t h) const { return origin_[h % 3 == 2 ? h - 2 : h + 1]; }
    std::uint32_t lower(std::uint32_t h) const { return std::min(origin_[h], target(h)); }
    std::uint32_t upper(std::uint32_t h) const { return std::max(origin_[h], target(h)); }

    const std::vector<std::uint32_t>& origin_;
    std::vector<std::uint32_t> start_, sorted_; // by lower vertex
};

/// Finds edges at which triangles are on the same three vertices.
class CoincidentTriangleSearch {
public:
    explicit CoincidentTriangleSearch(const std::vector<std::uint32_t>& origin) : origin_(origin) {}

    /// Whether two of the triangles at an edge have the same corner opposite to it.
    bool finds(const std::uint32_t* run, std::size_t count) {
        if (count < 2) return false;
        if (count == 2) return opposite(run[0]) == opposite(run[1]);
        opposite_.clear();
        for (std::size_t i = 0; i < count; ++i) opposite_.push_back(opposite(run[i]));
        std::sort(opposite_.begin(), opposite_.end());
        return std::adjacent_find(opposite_.begin(), opposite_.end()) != opposite_.end();
    }

private:
    std::uint32_t opposite(std::uint32_t h) const { return origin_[h % 3 == 0 ? h + 2 : h - 1]; }

    const std::vector<std::uint32_t>& origin_;
    std::vector<std::uint32_t> opposite_; // of the last edge with more than two triangles
};

} // namespace meshbound
