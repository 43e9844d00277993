#include "errors/propagated/propagated_removal.hpp"

#include <algorithm>
#include <limits>

namespace meshbound {

PropagatedRemoval::PropagatedRemoval(const Rows& rows, std::vector<ErrorInterval>& intervals,
                                     std::vector<double>& least, RetriangulationCost cost)
    : rows_(rows), intervals_(intervals), least_(least), cost_(cost), introduced_(width()) {}

void PropagatedRemoval::enter(const Hole& hole) {
    hole_ = &hole;
    map_.enter(rows_, hole);
}

double PropagatedRemoval::diagonal(int i, int j) {
    if (cost_ == RetriangulationCost::maximum)
        return 0; // charged with the triangles, whose intervals hold the crossings
    double sum = 0;
    const RingRange range = crossed_spokes(*hole_, i, j);
    for (int n = 0; n < range.count; ++n)
        sum += squared_ratio(map_.crossing(i, j, (range.first + n) % hole_->size()), rows_.groups());
    return sum;
}

double PropagatedRemoval::triangle(int a, int m, int b, double) {
    if (cost_ == RetriangulationCost::introduced)
        return contains_candidate(*hole_, a, m, b) ? squared_ratio(map_.candidate(a, m, b), rows_.groups()) : 0;
    fresh_.resize(width());
    propagate(a, m, b, fresh_.data());
    return worst(fresh_.data(), least_multiplier(a, m, b)).squared_ratio;
}

/// The interval of a new triangle: the union over its pieces, one in each sector that it overlaps.
void PropagatedRemoval::propagate(int a, int m, int b, ErrorInterval* fresh) {
    const double* candidate = contains_candidate(*hole_, a, m, b) ? map_.candidate(a, m, b) : nullptr;
    const RingRange sectors = overlapped_sectors(*hole_, a, m, b);
    constexpr double infinity = std::numeric_limits<double>::infinity();
    std::fill(fresh, fresh + width(), ErrorInterval{infinity, -infinity});
    for (int n = 0; n < sectors.count; ++n) add_piece(a, m, b, (sectors.first + n) % hole_->size(), candidate, fresh);
}

/// The piece of the new triangle in one sector. Its corners: crossings of the triangle's edges with the sector's two spokes,
/// ring vertices (which do not move, error 0), and the candidate.
void PropagatedRemoval::add_piece(int a, int m, int b, int sector, const double* candidate, ErrorInterval* fresh) {
    bool any = false;
    const auto include = [&](const double* difference) {
        for (std::size_t i = 0; i < width(); ++i) {
            const double value = difference ? difference[i] : 0;
            if (any) introduced_[i].include({value, value});
            else introduced_[i] = {value, value};
        }
        any = true;
    };
    if (candidate) include(candidate);
    for (const int spoke : {sector, hole_->after(sector)}) {
        if (spoke == a || spoke == m || spoke == b) include(nullptr);
        for (const auto& [i, j] : {std::pair{a, m}, std::pair{m, b}, std::pair{a, b}})
            if (const double* crossing = map_.crossing(i, j, spoke)) include(crossing);
    }
    const ErrorInterval* old = &intervals_[hole_->slots[static_cast<std::size_t>(sector)] * width()];
    for (std::size_t i = 0; i < width(); ++i)
        fresh[i].include({old[i].lowest + introduced_[i].lowest, old[i].highest + introduced_[i].highest});
}

/// A lower bound of the multipliers of all points mapped into a new triangle: they come from the sectors that it
/// overlaps.
double PropagatedRemoval::least_multiplier(int a, int m, int b) const {
    if (least_.empty()) return 1;
    const RingRange sectors = overlapped_sectors(*hole_, a, m, b);
    double least = std::numeric_limits<double>::infinity();
    for (int n = 0; n < sectors.count; ++n)
        least = std::min(least, least_[hole_->slots[static_cast<std::size_t>((sectors.first + n) % hole_->size())]]);
    return least;
}

RemovalError PropagatedRemoval::worst(const ErrorInterval* intervals, double multiplier) const {
    RemovalError measured;
    for (const RowGroup& group : rows_.groups()) {
        if (!group.bounded) continue;
        double square = 0;
        for (int i = group.first; i < group.first + group.count; ++i) {
            const double magnitude = intervals[i].magnitude();
            square += magnitude * magnitude;
        }
        if (square > measured.squared_ratio) measured = {square, group.variable};
    }
    measured.squared_ratio /= multiplier * multiplier;
    return measured;
}

RemovalError PropagatedRemoval::measure(const Retriangulation& retriangulation, double squared_limit) {
    RemovalError measured;
    fresh_.resize(retriangulation.triangles.size() * width());
    fresh_least_.clear();
    ErrorInterval* fresh = fresh_.data();
    for (const NewTriangle& triangle : retriangulation.triangles) {
        propagate(triangle.a, triangle.m, triangle.b, fresh);
        fresh_least_.push_back(least_multiplier(triangle.a, triangle.m, triangle.b));
        if (const RemovalError here = worst(fresh, fresh_least_.back()); here.squared_ratio > measured.squared_ratio)
            measured = here;
        if (measured.squared_ratio > squared_limit) break;
        fresh += width();
    }
    return measured;
}

void PropagatedRemoval::commit(const Retriangulation& retriangulation) {
    const ErrorInterval* fresh = fresh_.data();
    for (const NewTriangle& triangle : retriangulation.triangles) {
        if (!least_.empty())
            least_[triangle.slot] =
                fresh_least_[static_cast<std::size_t>(&triangle - retriangulation.triangles.data())];
        std::copy(fresh, fresh + width(), &intervals_[triangle.slot * width()]);
        fresh += width();
    }
}

} // namespace meshbound
