#include "tracked_cost.hpp"

#include "layout.hpp"
#include "overlap.hpp"

namespace meshbound {
namespace {

/// Of the vertices in a hole no more than about this many are asked: enough to tell good triangulations from bad ones (all
/// of them leave no fewer triangles), few enough not to be what the time goes into.
constexpr std::size_t vertices_asked = 32;

std::size_t at(int i) { return static_cast<std::size_t>(i); }

} // namespace

void TrackedCost::enter(const Hole& hole, const HoleContent& content) {
    hole_ = &hole;
    sample_.clear();
    if (hole.size() == 3) return; // one triangulation, nothing to choose
    const std::size_t stride = 1 + content.vertices().size() / vertices_asked;
    for (std::size_t i = 0; i < content.vertices().size(); i += stride)
        if (content.vertices()[i].host == InnerVertex::Host::triangle) sample_.push_back(content.vertices()[i]);
}

double TrackedCost::diagonal(int i, int j) {
    const auto row = [&](int ring) { return (*rows_)[hole_->ring[at(ring)]]; };
    const double* candidate = (*rows_)[hole_->candidate];
    const RingRun run = crossed_spokes(*hole_, i, j);
    double sum = 0;
    for (int n = 0; n < run.count; ++n) {
        const double* tip = row((run.first + n) % hole_->size());
        const glm::dvec2 at_nearest = nearest_parameters(*rows_, {candidate, tip}, 0, 1, {row(i), row(j)});
        sum += rows_->squared_ratio(
            MeasuredRows::segment_difference(candidate, tip, at_nearest.x, row(i), row(j), at_nearest.y));
    }
    return sum;
}

double TrackedCost::triangle(int a, int m, int b) {
    if (sample_.empty()) return 0;
    const glm::dvec2 &p = hole_->places[at(a)], &q = hole_->places[at(m)], &r = hole_->places[at(b)];
    const auto row = [&](int ring) { return (*rows_)[hole_->ring[at(ring)]]; };
    const JointTriangle joint(*rows_, row(a), row(m), row(b));
    double sum = 0;
    for (const InnerVertex& inner : sample_) {
        if (orientation(p, q, inner.place) < 0 || orientation(q, r, inner.place) < 0 ||
            orientation(r, p, inner.place) < 0)
            continue;
        const double* vertex = (*rows_)[inner.vertex];
        sum += joint.squared_ratio(*rows_, vertex, joint.nearest(*rows_, vertex));
    }
    return sum;
}

} // namespace meshbound
