#pragma once

#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

#include "surface/hole.hpp"
#include "util/indexing.hpp"
#include "retriangulation/original_normals.hpp"
#include "geometry/plane.hpp"
#include "retriangulation/ring_triangle.hpp"
#include "metric/rows.hpp"
#include "surface/surface.hpp"

namespace meshbound {

/// Which retriangulations of a hole keep the surface a surface (§3.2.3): no edge and no triangle twice, no two neighbouring
/// triangles that fold onto each other, none that turns more than a right angle against the original, no diagonal of an open hole that leaves the candidate inside.
class Legality {
public:
    /// `minds_turns`: whether new triangles must keep to the hole's normal too.
    Legality(const OriginalNormals& original, bool minds_turns) : original_(original), minds_turns_(minds_turns) {}

    /// Looks at the hole (laid out). Returns false where no retriangulation at all is legal for topological reasons.
    bool enter(const Surface& surface, const Rows& rows, const Hole& hole);

    /// Whether the edge between ring positions i < j may be made, as far as is known; neighbours on the ring always have
    /// theirs.
    bool allows_edge(int i, int j) const {
        const int size = hole_->size();
        if (j == i + 1 || (i == 0 && j == size - 1)) return true;
        return taken_[at(i * size + j)] != Taken::yes && (!hole_->open || leaves_candidate(i, j));
    }

    /// Whether the diagonals exist nowhere on the surface yet. One that does is not allowed from then on: few retriangulations
    /// have any, so that they are looked for only in those that were chosen.
    bool allows_diagonals(const Retriangulation& retriangulation);

    /// Whether a triangle keeps its orientation in the layout: cheap, to be asked before it is looked at in space.
    bool lies_open(int a, int m, int b) const {
        return orientation(hole_->places[at(a)], hole_->places[at(m)], hole_->places[at(b)]) > least_area_;
    }

    /// Whether a triangle that lies open may be made, its edges being allowed.
    bool allows_triangle(const RingTriangle& triangle) const;

    /// The same for a triangle whose neighbours across (a, m) and (m, b) have the normals `left` and `right`; none where these
    /// are rims.
    bool allows_neighbours(const RingTriangle& triangle, const glm::dvec3* left, const glm::dvec3* right) const;

private:
    bool removable(const Surface& surface, const Hole& hole) const;
    bool touches_own_site(const Surface& surface, const Hole& hole) const;
    void find_taken_edges(const Surface& surface, const Hole& hole);
    void find_neighbours(const Surface& surface, const Rows& rows, const Hole& hole);
    bool leaves_candidate(int i, int j) const;
    void keep_to(const glm::dvec3& normal);
    void find_directions(const Hole& hole);
    void take(int i, int j);
    bool is_taken(int i, int j);
    void see(std::uint32_t site, int i);
    double sharpest_bend() const;
    bool folds(const glm::dvec3& p, const glm::dvec3& q) const;
    bool folds_onto_neighbour(const RingTriangle& triangle, int rim) const;

    bool turns_from_original(const RingTriangle& triangle) const;

    enum class Taken : std::uint8_t { unknown, no, yes };

    const OriginalNormals& original_;
    bool minds_turns_;
    const Surface* surface_ = nullptr;
    const Hole* hole_ = nullptr;
    glm::dvec3 normal_{0};             // of the hole, of unit length
    double least_cosine_ = 0;          // between it and the normal of a triangle that minds turns
    double least_area_ = 0;            // of a laid-out triangle, twice
    std::uint64_t ring_filter_ = 0;    // a bit for the last digits of each ring vertex: most others are told from them
    std::vector<std::uint32_t> sites_; // of the ring
    std::vector<Taken> taken_;         // [i * size + j]: whether the edge exists
    std::vector<glm::dvec3> neighbours_; // by rim: normal of the triangle outside, or zero
    std::vector<glm::dvec3> directions_; // by ring position: where the original faces
};

} // namespace meshbound
