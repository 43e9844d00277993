#pragma once

#include <cstdint>
#include <vector>

#include "errors/tracked/hole_products.hpp"
#include "errors/tracked/mapped_content.hpp"
#include "retriangulation/retriangulation.hpp"

namespace meshbound {

/// The cost of a retriangulation when errors are tracked: the squared errors, against the original, of the vertices in
/// the hole where the layout puts them, and those between each diagonal and the spokes that it crosses, at their
/// nearest points.
class TrackedCost final : public HoleCost {
public:
    TrackedCost(const BoundedRows& rows, const HoleProducts& products) : rows_(rows), products_(products) {}

    void enter(const Hole& hole, const std::vector<InnerVertex>& inner);
    double diagonal(int i, int j) override;
    double triangle(int a, int m, int b, double limit) override;

private:
    void take_sample();
    void find_sides();
    const double* row(int ring) const { return products_.ring_row(ring); }

    const BoundedRows& rows_;
    const HoleProducts& products_;
    const Hole* hole_ = nullptr;
    const std::vector<InnerVertex>* inner_ = nullptr;
    std::vector<std::uint32_t> sample_; // of the inner vertices
    std::vector<std::uint64_t> left_;   // [i * size + j], i < j: the sample's vertices left of the diagonal, a bit each
    std::vector<std::uint64_t> right_;  // and those right of it; those on it are on both sides
};

} // namespace meshbound
