#include "errors/tracked/tracked_cost.hpp"

#include <bit>

#include "errors/tracked/joint_space.hpp"
#include "geometry/plane.hpp"
#include "retriangulation/overlap.hpp"
#include "util/indexing.hpp"

namespace meshbound {
namespace {

/// About so many of the vertices in a hole are sampled at most, which is enough to tell good triangulations from bad
/// ones. No more than 64: each has a bit.
constexpr std::size_t vertices_asked = 8;

} // namespace

void TrackedCost::enter(const Hole& hole, const std::vector<InnerVertex>& inner) {
    hole_ = &hole;
    inner_ = &inner;
    sample_.clear();
    if (hole.size() == 3) return; // one triangulation, nothing to choose
    take_sample();
    find_sides();
}

void TrackedCost::take_sample() {
    const std::vector<InnerVertex>& inner = *inner_;
    const std::size_t stride = 1 + inner.size() / vertices_asked;
    for (std::size_t i = 0; i < inner.size(); i += stride)
        if (inner[i].container == InnerVertex::Container::triangle) sample_.push_back(static_cast<std::uint32_t>(i));
}

void TrackedCost::find_sides() {
    const std::vector<InnerVertex>& inner = *inner_;
    const int size = hole_->size();
    left_.resize(to_index(size * size));
    right_.resize(to_index(size * size));
    for (int i = 0; i < size; ++i)
        for (int j = i + 1; j < size; ++j) {
            std::uint64_t left = 0, right = 0;
            for (std::size_t n = 0; n < sample_.size(); ++n) {
                const double side =
                    orientation(hole_->layout[to_index(i)], hole_->layout[to_index(j)], inner[sample_[n]].layout);
                left |= std::uint64_t{side >= 0} << n;
                right |= std::uint64_t{side <= 0} << n;
            }
            left_[to_index(i * size + j)] = left;
            right_[to_index(i * size + j)] = right;
        }
}

double TrackedCost::diagonal(int i, int j) {
    const double* candidate = rows_[hole_->candidate];
    const double ii = products_.ring(i, i), ij = products_.ring(i, j), jj = products_.ring(j, j);
    const RingRange range = crossed_spokes(*hole_, i, j);
    double sum = 0;
    for (int n = 0; n < range.count; ++n) {
        const int tip = (range.first + n) % hole_->size();
        // The spoke begins at the candidate, which is the origin: u is the tip, v = i - j, w the ring index i.
        const double uw = products_.ring(tip, i), uv = uw - products_.ring(tip, j);
        const glm::dvec2 near =
            nearest_parameters({{products_.ring(tip, tip), uv, jj - 2 * ij + ii, uw, ii - ij, ii}}, 0, 1);
        sum +=
            rows_.squared_ratio(BoundedRows::segment_difference(candidate, row(tip), near.x, row(i), row(j), near.y));
    }
    return rows_.multipliers().scale_at(hole_->candidate, sum);
}

double TrackedCost::triangle(int a, int m, int b, double limit) {
    if (sample_.empty()) return 0;
    const int size = hole_->size();
    std::uint64_t inside =
        left_[to_index(a * size + m)] & left_[to_index(m * size + b)] & right_[to_index(a * size + b)];
    if (!inside) return 0;
    const std::vector<glm::dvec2>& ring_layout = hole_->layout;
    double sum = 0;
    for (; inside && sum < limit; inside &= inside - 1) {
        const auto& [vertex, container, link_edge, layout, share, share_is_fixed] =
            (*inner_)[sample_[static_cast<std::size_t>(std::countr_zero(inside))]];
        const glm::dvec3 w =
            clamped_barycentric(layout, ring_layout[to_index(a)], ring_layout[to_index(m)], ring_layout[to_index(b)]);
        const double ratio = rows_.squared_ratio(rows_[vertex], row(a), row(m), row(b), w.x, w.y, w.z);
        sum += rows_.multipliers().scale_at(vertex, ratio);
    }
    return sum;
}

} // namespace meshbound
