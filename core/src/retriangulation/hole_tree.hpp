#pragma once

#include <vector>

#include "surface/hole.hpp"
#include "util/indexing.hpp"

namespace meshbound {

/// The tree of a retriangulation's triangles across its diagonals: where each rim hangs on it, and the way from one triangle
/// to another, which is unique and needs no geometry.
class HoleTree {
public:
    void enter(const Hole& hole, const Retriangulation& retriangulation);

    /// A diagonal on the way: that of `triangle` to its parent, crossed into the triangle or out of it.
    struct Step {
        int triangle = 0;
        bool into = false;
    };

    /// The new triangle at a rim (of the closing edge of an open hole: the root); a triangle at the ring vertex before it.
    int at_rim(int rim) const { return at_rim_[at(rim)]; }
    /// Across (a, b) of a triangle.
    const NewTriangle& triangle(int n) const { return (*triangles_)[at(n)]; }

    /// The diagonals between two triangles, less those that touch ring position `start` at the beginning or `end` at the end
    /// (-1: none does). Overwritten by the next call.
    const std::vector<Step>& way(int from, int start, int to, int end);

private:
    bool touches(const Step& step, int ring) const;

    const std::vector<NewTriangle>* triangles_ = nullptr;
    std::vector<int> depth_;  // by new triangle
    std::vector<int> at_rim_; // by rim: its new triangle
    std::vector<Step> way_, down_;
};

} // namespace meshbound
