#pragma once

#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

#include "geometry/plane.hpp"
#include "metric/rows.hpp"
#include "retriangulation/original_normals.hpp"
#include "retriangulation/ring_triangle.hpp"
#include "surface/hole.hpp"
#include "surface/surface.hpp"
#include "util/indexing.hpp"

namespace meshbound {

/// Which retriangulations of a hole are legal (§3.2.3): no edge and no triangle twice, no two neighbouring triangles
/// that fold onto each other, no normal that deviates by more than a right angle from the original's, no diagonal of an
/// open hole that cuts the candidate off from the closing edge.
class Legality {
public:
    /// `limits_normal_deviation`: whether the normals of new triangles must keep to the hole's, too.
    Legality(const OriginalNormals& original, bool limits_normal_deviation)
        : original_(original), limits_normal_deviation_(limits_normal_deviation) {}

    /// Prepares for a hole, which is laid out. Returns false where the link condition forbids every retriangulation.
    bool enter(const Surface& surface, const Rows& rows, const Hole& hole);

    /// Whether the edge between ring indices i < j is legal, as far as is known; adjacent ones always have their link
    /// edge.
    bool allows_edge(int i, int j) const {
        const int size = hole_->size();
        if (j == i + 1 || (i == 0 && j == size - 1)) return true;
        return edge_existence_[to_index(i * size + j)] != EdgeExistence::yes &&
               (!hole_->open || leaves_candidate(i, j));
    }

    /// Whether none of the diagonals exists on the surface already. One that does is not allowed from then on. Few
    /// retriangulations have one, so only those that were chosen are checked.
    bool allows_diagonals(const Retriangulation& retriangulation);

    /// Whether a triangle is counter-clockwise in the layout: a cheap test that comes before those in space.
    bool is_ccw_in_layout(int a, int m, int b) const {
        return orientation(hole_->layout[to_index(a)], hole_->layout[to_index(m)], hole_->layout[to_index(b)]) >
               least_area_;
    }

    /// Whether a triangle that is counter-clockwise in the layout, and whose edges are legal, is legal itself.
    bool allows_triangle(const RingTriangle& triangle) const;

    /// The same of the diagonals to the neighbours across (a, m) and (m, b), by their normals `left` and `right`; null
    /// where these are link edges.
    bool allows_neighbours(const RingTriangle& triangle, const glm::dvec3* left, const glm::dvec3* right) const;

private:
    bool topology_allows_removal(const Surface& surface, const Hole& hole) const;
    bool touches_own_class(const Surface& surface, const Hole& hole) const;
    void find_existing_edges(const Surface& surface, const Hole& hole);
    void find_neighbours(const Surface& surface, const Rows& rows, const Hole& hole);
    bool leaves_candidate(int i, int j) const;
    void limit_deviation_from(const glm::dvec3& normal);
    void look_up_original_normals(const Hole& hole);
    void mark_existing_edge(int i, int j);
    bool edge_exists(int i, int j);
    void mark_edges_to(std::uint32_t representative, int i);
    double sharpest_bend() const;
    bool folds(const glm::dvec3& p, const glm::dvec3& q) const;
    bool folds_onto_neighbour(const RingTriangle& triangle, int link_edge) const;

    bool deviates_from_original(const RingTriangle& triangle) const;

    enum class EdgeExistence : std::uint8_t { unknown, no, yes };

    const OriginalNormals& original_;
    bool limits_normal_deviation_;
    const Surface* surface_ = nullptr;
    const Hole* hole_ = nullptr;
    glm::dvec3 normal_{0};                            // of the hole, of unit length
    double least_cosine_ = 0;                         // between it and the normals of new triangles
    double least_area_ = 0;                           // of a laid-out triangle, twice
    std::uint64_t ring_filter_ = 0;                   // a Bloom filter of the ring, by vertex modulo 64
    std::vector<std::uint32_t> ring_representatives_; // of the ring
    std::vector<EdgeExistence> edge_existence_;       // [i * size + j]: whether the edge exists
    std::vector<glm::dvec3> neighbours_;              // by link edge: normal of the triangle outside, or zero
    std::vector<glm::dvec3> original_normals_;        // by ring index
};

} // namespace meshbound
