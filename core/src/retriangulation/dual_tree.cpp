#include "retriangulation/dual_tree.hpp"

namespace meshbound {

void DualTree::enter(const Hole& hole, const Retriangulation& retriangulation) {
    triangles_ = &retriangulation.triangles;
    depth_.clear();
    at_link_edge_.assign(to_index(hole.size()), 0);
    for (const NewTriangle& triangle : *triangles_) {
        const int n = static_cast<int>(depth_.size());
        depth_.push_back(triangle.parent < 0 ? 0 : depth_[to_index(triangle.parent)] + 1);
        if (triangle.left < 0) at_link_edge_[to_index(triangle.a)] = n;
        if (triangle.right < 0) at_link_edge_[to_index(triangle.m)] = n;
    }
}

bool DualTree::touches(const Step& step, int ring) const {
    return triangle(step.triangle).a == ring || triangle(step.triangle).b == ring;
}

const std::vector<DualTree::Step>& DualTree::path(int from, int start, int to, int end) {
    path_.clear();
    down_.clear();
    while (from != to) {
        if (depth_[to_index(from)] >= depth_[to_index(to)]) {
            if (!path_.empty() || !touches({from, false}, start)) path_.push_back({from, false});
            from = triangle(from).parent;
        } else {
            if (!down_.empty() || !touches({to, true}, end)) down_.push_back({to, true});
            to = triangle(to).parent;
        }
    }
    if (path_.empty())
        while (!down_.empty() && touches(down_.back(), start)) down_.pop_back();
    if (down_.empty())
        while (!path_.empty() && touches(path_.back(), end)) path_.pop_back();
    path_.insert(path_.end(), down_.rbegin(), down_.rend());
    return path_;
}

} // namespace meshbound
