#pragma once

#include <vector>

#include "surface/hole.hpp"
#include "util/indexing.hpp"

namespace meshbound {

/// The dual tree of a retriangulation: its triangles, adjacent across diagonals. It has the triangle at each link edge,
/// and the path from one triangle to another, which is unique and needs no geometry.
class DualTree {
public:
    void enter(const Hole& hole, const Retriangulation& retriangulation);

    /// A diagonal on a path: that of `triangle` to its parent, crossed into the triangle or out of it.
    struct Step {
        int triangle = 0;
        bool into = false;
    };

    /// The new triangle at a link edge (at the closing edge of an open hole: the root). It has the ring vertex at which
    /// the edge begins.
    int at_link_edge(int link_edge) const { return at_link_edge_[to_index(link_edge)]; }
    /// New triangle n. Its edge (a, b) is the diagonal to its parent.
    const NewTriangle& triangle(int n) const { return (*triangles_)[to_index(n)]; }

    /// The diagonals between two triangles, less those that end at ring index `start` at its beginning or at `end` at
    /// its end (-1: none). Overwritten by the next call.
    const std::vector<Step>& path(int from, int start, int to, int end);

private:
    bool touches(const Step& step, int ring) const;

    const std::vector<NewTriangle>* triangles_ = nullptr;
    std::vector<int> depth_;        // by new triangle
    std::vector<int> at_link_edge_; // by link edge: its new triangle
    std::vector<Step> path_, down_;
};

} // namespace meshbound
