#include "errors/tracked/laying.hpp"

#include <algorithm>

#include <glm/geometric.hpp>

#include "util/indexing.hpp"
#include "geometry/plane.hpp"

namespace meshbound {
namespace {

/// Neighbouring crossings stay apart on their original edge by at least this share of the room that is left there: at one place
/// Φ would open it into a segment, and be a map only in the limit.
constexpr double least_gap = 1e-12;

} // namespace

inline auto Laying::difference(const Piece& piece, const NewCrossing& crossing) const {
    const NewTriangle& triangle = tree_->triangle(crossing.triangle);
    return MeasuredRows::segment_difference(rows_[map_.edges.lower(piece.original)],
                                            rows_[map_.edges.upper(piece.original)], crossing.s,
                                            products_.ring_row(triangle.a), products_.ring_row(triangle.b), crossing.t);
}

double Laying::error(const Piece& piece, const NewCrossing& crossing) const {
    return rows_.multipliers().scale_between(map_.edges.lower(piece.original), map_.edges.upper(piece.original),
                                             crossing.s, rows_.squared_ratio(difference(piece, crossing)));
}

bool Laying::lay(const Hole& hole, HoleTree& tree, const Settling& settling, const std::vector<Piece>& pieces,
                 WorstError& worst) {
    hole_ = &hole;
    tree_ = &tree;
    settling_ = &settling;
    crossings_.clear();
    begin_.clear();
    for (const Piece& piece : pieces) {
        begin_.push_back(crossings_.size());
        const int from = triangle_at(piece.start), to = triangle_at(piece.end);
        if (from != to && !lay_piece(piece, from, to, worst)) return false;
    }
    begin_.push_back(crossings_.size());
    return true;
}

glm::dvec2 Laying::place_of(const PieceEnd& end) const {
    if (end.is_inner()) return settling_->places()[at(end.inner())];
    if (!end.is_crossing()) return hole_->places[at(end.ring())];
    const int i = end.rim(), j = hole_->after(i);
    const double t = map_.crossings[end.crossing].t;
    const double along = hole_->ring[at(i)] < hole_->ring[at(j)] ? t : 1 - t;
    return hole_->places[at(i)] + along * (hole_->places[at(j)] - hole_->places[at(i)]);
}

/// The s at which a piece starts: at no crossing, that of the original edge's lower end.
double Laying::start_of(const Piece& piece) const {
    return piece.start.is_crossing() ? map_.crossings[piece.start.crossing].s : 0;
}

double Laying::end_of(const Piece& piece) const {
    return piece.end.is_crossing() ? map_.crossings[piece.end.crossing].s : 1;
}

bool Laying::lay_piece(const Piece& piece, int from, int to, WorstError& worst) {
    const std::size_t first = crossings_.size();
    for (const HoleTree::Step& step : tree_->way(from, piece.start.ring(), to, piece.end.ring()))
        crossings_.push_back({step.triangle, 0, 0, step.into});
    cross_straight(piece, first);
    for (std::size_t n = first; n < crossings_.size(); ++n) {
        double here = error(piece, crossings_[n]);
        if (choose_crossings_ && here > worst.squared_content()) choose(piece, first, n, worst.squared_content(), here);
        if (!worst.take(here, [&] { return difference(piece, crossings_[n]); })) return false;
    }
    return true;
}

/// Crossings of the straight segment between the piece's ends with the diagonals on its way, each clamped into its
/// diagonal, in order along the piece: the order is all that the proof needs. A diagonal along the segment is crossed
/// wherever the two meet.
void Laying::cross_straight(const Piece& piece, std::size_t first) {
    if (first == crossings_.size()) return;
    const glm::dvec2 start = place_of(piece.start), direction = place_of(piece.end) - start;
    const double start_s = start_of(piece), end_s = end_of(piece);
    double reached = 0, before = start_s;
    for (std::size_t n = first; n < crossings_.size(); ++n) {
        NewCrossing& crossing = crossings_[n];
        const NewTriangle& triangle = tree_->triangle(crossing.triangle);
        const glm::dvec2 a = hole_->places[at(triangle.a)], along = hole_->places[at(triangle.b)] - a;
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

/// The freedom of Φ: s may be anywhere between its neighbours on the original edge, t anywhere on the diagonal.
void Laying::choose(const Piece& piece, std::size_t first, std::size_t n, double squared_content, double& error) {
    NewCrossing& crossing = crossings_[n];
    const double before = n == first ? start_of(piece) : crossings_[n - 1].s;
    const double behind = n + 1 == crossings_.size() ? end_of(piece) : crossings_[n + 1].s;
    const double low = std::min(crossing.s, before + least_gap * (behind - before));  // never below the one before …
    const double high = std::max(crossing.s, behind - least_gap * (behind - before)); // … nor above the one behind
    const JointSegment original{rows_[map_.edges.lower(piece.original)], rows_[map_.edges.upper(piece.original)]};
    const NewTriangle& triangle = tree_->triangle(crossing.triangle);
    const JointSegment diagonal{products_.ring_row(triangle.a), products_.ring_row(triangle.b)};
    const auto nearest = [&](const PlaneProducts& products) { return nearest_parameters(products, low, high); };
    take_better(piece, nearest(products_of(rows_, original, diagonal)), crossing, error);
    if (error <= squared_content) return;
    minimax_.enter(between(original, diagonal));
    Minimax::Place best{{crossing.s, crossing.t}, rows_.squared_ratio(difference(piece, crossing))};
    minimax_.improve(best, nearest);
    take_better(piece, best.at, crossing, error);
}

void Laying::take_better(const Piece& piece, const glm::dvec2& chosen, NewCrossing& crossing, double& error) const {
    NewCrossing other = crossing;
    other.s = chosen.x;
    other.t = chosen.y;
    const double here = this->error(piece, other);
    if (!(here < error)) return;
    error = here;
    crossing = other;
}

} // namespace meshbound
