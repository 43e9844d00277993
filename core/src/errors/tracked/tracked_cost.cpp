#include "errors/tracked/tracked_cost.hpp"

#include <bit>

#include "util/indexing.hpp"
#include "metric/joint_space.hpp"
#include "retriangulation/overlap.hpp"
#include "geometry/plane.hpp"

namespace meshbound {
namespace {

/// Of the vertices in a hole no more than about this many are asked, which is enough to tell good triangulations from bad
/// ones: 32 leave 0.5 % fewer triangles and take a sixth more time. At most 64, a bit each.
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
        if (inner[i].host == InnerVertex::Host::triangle) sample_.push_back(static_cast<std::uint32_t>(i));
}

void TrackedCost::find_sides() {
    const std::vector<InnerVertex>& inner = *inner_;
    const int size = hole_->size();
    left_.resize(at(size * size));
    right_.resize(at(size * size));
    for (int i = 0; i < size; ++i)
        for (int j = i + 1; j < size; ++j) {
            std::uint64_t left = 0, right = 0;
            for (std::size_t n = 0; n < sample_.size(); ++n) {
                const double side = orientation(hole_->places[at(i)], hole_->places[at(j)], inner[sample_[n]].place);
                left |= std::uint64_t{side >= 0} << n;
                right |= std::uint64_t{side <= 0} << n;
            }
            left_[at(i * size + j)] = left;
            right_[at(i * size + j)] = right;
        }
}

double TrackedCost::diagonal(int i, int j) {
    const double* candidate = rows_[hole_->candidate];
    const double ii = products_.ring(i, i), ij = products_.ring(i, j), jj = products_.ring(j, j);
    const RingRun run = crossed_spokes(*hole_, i, j);
    double sum = 0;
    for (int n = 0; n < run.count; ++n) {
        const int tip = (run.first + n) % hole_->size();
        // The spoke begins at the candidate, which is the origin: u is the tip, v = i - j, w the ring position i.
        const double uw = products_.ring(tip, i), uv = uw - products_.ring(tip, j);
        const glm::dvec2 near =
            nearest_parameters({{products_.ring(tip, tip), uv, jj - 2 * ij + ii, uw, ii - ij, ii}}, 0, 1);
        sum +=
            rows_.squared_ratio(MeasuredRows::segment_difference(candidate, row(tip), near.x, row(i), row(j), near.y));
    }
    return rows_.multipliers().scale_at(hole_->candidate, sum);
}

double TrackedCost::triangle(int a, int m, int b, double limit) {
    if (sample_.empty()) return 0;
    const int size = hole_->size();
    std::uint64_t inside = left_[at(a * size + m)] & left_[at(m * size + b)] & right_[at(a * size + b)];
    if (!inside) return 0;
    const std::vector<glm::dvec2>& places = hole_->places;
    double sum = 0;
    for (; inside && sum < limit; inside &= inside - 1) {
        const auto& [vertex, host, rim, place, share, settled] =
            (*inner_)[sample_[static_cast<std::size_t>(std::countr_zero(inside))]];
        const glm::dvec3 w = clamped_barycentric(place, places[at(a)], places[at(m)], places[at(b)]);
        const double ratio = rows_.squared_ratio(rows_[vertex], row(a), row(m), row(b), w.x, w.y, w.z);
        sum += rows_.multipliers().scale_at(vertex, ratio);
    }
    return sum;
}

} // namespace meshbound
