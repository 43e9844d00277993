#pragma once

#include <vector>

#include "hole_content.hpp"
#include "joint_space.hpp"
#include "retriangulation.hpp"

namespace meshbound {

/// What a retriangulation is charged for when errors are tracked: the squared errors, against the original, that the vertices
/// in the hole could have at their best places in each triangle, and those between each diagonal and the spokes that it
/// crosses, at their nearest places. Leaves 4 % fewer triangles than the introduced errors of §3.4.1.
class TrackedCost final : public HoleCost {
public:
    explicit TrackedCost(const MeasuredRows& rows) : rows_(&rows) {}

    void enter(const Hole& hole, const HoleContent& content);
    double diagonal(int i, int j) override;
    double triangle(int a, int m, int b) override;

private:
    const MeasuredRows* rows_;
    const Hole* hole_ = nullptr;
    std::vector<InnerVertex> sample_; // of the vertices in the hole
};

} // namespace meshbound
