#include "retriangulation/hole_tree.hpp"

namespace meshbound {

void HoleTree::enter(const Hole& hole, const Retriangulation& retriangulation) {
    triangles_ = &retriangulation.triangles;
    depth_.clear();
    at_rim_.assign(at(hole.size()), 0);
    for (const NewTriangle& triangle : *triangles_) {
        const int n = static_cast<int>(depth_.size());
        depth_.push_back(triangle.parent < 0 ? 0 : depth_[at(triangle.parent)] + 1);
        if (triangle.left < 0) at_rim_[at(triangle.a)] = n;
        if (triangle.right < 0) at_rim_[at(triangle.m)] = n;
    }
}

bool HoleTree::touches(const Step& step, int ring) const {
    return triangle(step.triangle).a == ring || triangle(step.triangle).b == ring;
}

const std::vector<HoleTree::Step>& HoleTree::way(int from, int start, int to, int end) {
    way_.clear();
    down_.clear();
    while (from != to) {
        if (depth_[at(from)] >= depth_[at(to)]) {
            if (!way_.empty() || !touches({from, false}, start)) way_.push_back({from, false});
            from = triangle(from).parent;
        } else {
            if (!down_.empty() || !touches({to, true}, end)) down_.push_back({to, true});
            to = triangle(to).parent;
        }
    }
    if (way_.empty())
        while (!down_.empty() && touches(down_.back(), start)) down_.pop_back();
    if (down_.empty())
        while (!way_.empty() && touches(way_.back(), end)) way_.pop_back();
    way_.insert(way_.end(), down_.rbegin(), down_.rend());
    return way_;
}

} // namespace meshbound
