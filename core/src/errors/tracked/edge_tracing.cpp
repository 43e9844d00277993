#include "errors/tracked/edge_tracing.hpp"

#include <algorithm>

#include <glm/geometric.hpp>

#include "geometry/plane.hpp"
#include "util/indexing.hpp"

namespace meshbound {
namespace {

/// Neighbouring crossings stay apart on their original edge by at least this share of the room that is left: if they
/// coincided, Φ would map one point to a segment, and be a map only in the limit.
constexpr double least_gap = 1e-12;

} // namespace

inline auto EdgeTracing::difference(const EdgeSegment& segment, const NewCrossing& crossing) const {
    const NewTriangle& triangle = tree_->triangle(crossing.triangle);
    return BoundedRows::segment_difference(rows_[map_.edges.lower(segment.original)],
                                           rows_[map_.edges.upper(segment.original)], crossing.s,
                                           products_.ring_row(triangle.a), products_.ring_row(triangle.b), crossing.t);
}

double EdgeTracing::error(const EdgeSegment& segment, const NewCrossing& crossing) const {
    return rows_.multipliers().scale_between(map_.edges.lower(segment.original), map_.edges.upper(segment.original),
                                             crossing.s, rows_.squared_ratio(difference(segment, crossing)));
}

bool EdgeTracing::trace(const Hole& hole, DualTree& tree, const VertexRelocation& relocation,
                        const std::vector<EdgeSegment>& segments, WorstError& worst) {
    hole_ = &hole;
    tree_ = &tree;
    relocation_ = &relocation;
    crossings_.clear();
    begin_.clear();
    for (const EdgeSegment& segment : segments) {
        begin_.push_back(crossings_.size());
        const int from = triangle_at(segment.start), to = triangle_at(segment.end);
        if (from != to && !trace_segment(segment, from, to, worst)) return false;
    }
    begin_.push_back(crossings_.size());
    return true;
}

glm::dvec2 EdgeTracing::layout_of(const SegmentEnd& end) const {
    if (end.is_inner()) return relocation_->layout()[to_index(end.inner())];
    if (!end.is_crossing()) return hole_->layout[to_index(end.ring())];
    const int i = end.link_edge(), j = hole_->after(i);
    const double t = map_.crossings[end.crossing].t;
    const double along = hole_->ring[to_index(i)] < hole_->ring[to_index(j)] ? t : 1 - t;
    return hole_->layout[to_index(i)] + along * (hole_->layout[to_index(j)] - hole_->layout[to_index(i)]);
}

/// The s at which a segment starts; 0 where it starts at the original edge's lower end.
double EdgeTracing::start_of(const EdgeSegment& segment) const {
    return segment.start.is_crossing() ? map_.crossings[segment.start.crossing].s : 0;
}

double EdgeTracing::end_of(const EdgeSegment& segment) const {
    return segment.end.is_crossing() ? map_.crossings[segment.end.crossing].s : 1;
}

bool EdgeTracing::trace_segment(const EdgeSegment& segment, int from, int to, WorstError& worst) {
    const std::size_t first = crossings_.size();
    for (const DualTree::Step& step : tree_->path(from, segment.start.ring(), to, segment.end.ring()))
        crossings_.push_back({step.triangle, 0, 0, step.into});
    cross_straight(segment, first);
    for (std::size_t n = first; n < crossings_.size(); ++n) {
        double here = error(segment, crossings_[n]);
        if (optimize_crossings_ && here > worst.squared_threshold())
            optimize(segment, first, n, worst.squared_threshold(), here);
        if (!worst.include(here, [&] { return difference(segment, crossings_[n]); })) return false;
    }
    return true;
}

/// Puts the crossings where the straight line between the segment's ends meets the diagonals on its path, each clamped
/// into its diagonal, in order along the segment: the order is all that the proof needs. A diagonal parallel to the
/// line is crossed anywhere.
void EdgeTracing::cross_straight(const EdgeSegment& segment, std::size_t first) {
    if (first == crossings_.size()) return;
    const glm::dvec2 start = layout_of(segment.start), direction = layout_of(segment.end) - start;
    const double start_s = start_of(segment), end_s = end_of(segment);
    double reached = 0, before = start_s;
    for (std::size_t n = first; n < crossings_.size(); ++n) {
        NewCrossing& crossing = crossings_[n];
        const NewTriangle& triangle = tree_->triangle(crossing.triangle);
        const glm::dvec2 a = hole_->layout[to_index(triangle.a)], along = hole_->layout[to_index(triangle.b)] - a;
        const double denominator = cross(direction, along);
        const double meeting = denominator != 0 ? cross(a - start, along) / denominator
                                                : glm::dot(a - start, direction) / glm::dot(direction, direction);
        const double low = reached + least_gap * (1 - reached), high = 1 - least_gap * (1 - low);
        reached = clamped(meeting, low, high);
        crossing.t = clamped(glm::dot(start + reached * direction - a, along) / glm::dot(along, along), 0, 1);
        // Where the room is a few units in the last place, rounding would put it beyond its neighbours.
        crossing.s = before = clamped(start_s + reached * (end_s - start_s), before, end_s);
    }
}

/// Φ is free: s may be anywhere between its neighbours on the original edge, t anywhere on the diagonal.
void EdgeTracing::optimize(const EdgeSegment& segment, std::size_t first, std::size_t n, double squared_threshold,
                           double& error) {
    NewCrossing& crossing = crossings_[n];
    const double before = n == first ? start_of(segment) : crossings_[n - 1].s;
    const double behind = n + 1 == crossings_.size() ? end_of(segment) : crossings_[n + 1].s;
    const double low = std::min(crossing.s, before + least_gap * (behind - before));  // never below the one before …
    const double high = std::max(crossing.s, behind - least_gap * (behind - before)); // … nor above the one after
    const JointSegment original{rows_[map_.edges.lower(segment.original)], rows_[map_.edges.upper(segment.original)]};
    const NewTriangle& triangle = tree_->triangle(crossing.triangle);
    const JointSegment diagonal{products_.ring_row(triangle.a), products_.ring_row(triangle.b)};
    const auto nearest = [&](const PlaneProducts& products) { return nearest_parameters(products, low, high); };
    replace_if_better(segment, nearest(products_of(rows_, original, diagonal)), crossing, error);
    if (error <= squared_threshold) return;
    minimax_.enter(between(original, diagonal));
    Minimax::Solution best{{crossing.s, crossing.t}, rows_.squared_ratio(difference(segment, crossing))};
    minimax_.improve(best, nearest);
    replace_if_better(segment, best.parameters, crossing, error);
}

void EdgeTracing::replace_if_better(const EdgeSegment& segment, const glm::dvec2& chosen, NewCrossing& crossing,
                                    double& error) const {
    NewCrossing other = crossing;
    other.s = chosen.x;
    other.t = chosen.y;
    const double here = this->error(segment, other);
    if (!(here < error)) return;
    error = here;
    crossing = other;
}

} // namespace meshbound
