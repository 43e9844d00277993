#pragma once

#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

#include "hole.hpp"
#include "rows.hpp"
#include "surface.hpp"

namespace meshbound {

/// Which retriangulations of a hole keep the surface a surface (§3.2.3): no edge and no triangle twice, no two neighbouring
/// triangles that fold onto each other, no diagonal of an open hole that leaves the candidate inside.
class Legality {
public:
    /// `minds_turns`: whether new triangles must keep to the hole's normal too.
    Legality(const Surface& surface, bool minds_turns);

    /// Looks at the hole (laid out). Returns false where no retriangulation at all is legal for topological reasons.
    bool enter(const Surface& surface, const Rows& rows, const Hole& hole);

    /// Whether the edge between ring positions i < j may be made; neighbours on the ring always have theirs.
    bool allows_edge(int i, int j) const;

    /// Whether the triangle of ring positions a < m < b may be made, its edges being allowed.
    bool allows_triangle(int a, int m, int b) const;

    /// The same for a triangle whose neighbours across (a, m) and (m, b) have the third corners `left` and `right`; -1 where
    /// these are rims.
    bool allows_neighbours(int a, int m, int b, int left, int right) const;

private:
    bool removable(const Surface& surface, const Hole& hole) const;
    void find_taken_edges(const Surface& surface, const Hole& hole);
    void find_neighbours(const Surface& surface, const Rows& rows, const Hole& hole);
    double sharpest_bend(const Rows& rows, const Hole& hole) const;
    glm::dvec3 normal(int a, int m, int b) const;
    bool folds(const glm::dvec3& p, const glm::dvec3& q) const;
    bool folds_onto_neighbour(const glm::dvec3& normal, int rim) const;

    bool minds_turns_;
    const Rows* rows_ = nullptr;
    const Hole* hole_ = nullptr;
    glm::dvec3 normal_{0};               // of the hole
    double least_bend_cosine_ = 0;       // across every edge inside the hole and on its rims
    double scale_ = 0;                   // squared size of the laid-out hole
    std::vector<char> taken_;            // [i * size + j]: the edge exists
    std::vector<glm::dvec3> neighbours_; // by rim: normal of the triangle outside, or zero
    std::vector<int> ring_position_;     // by vertex, -1 elsewhere
};

} // namespace meshbound
