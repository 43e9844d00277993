#include "errors/propagated/propagation.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "errors/propagated/propagated_removal.hpp"
#include "util/indexing.hpp"

namespace meshbound {

Propagation::Propagation(const Rows& rows, const Surface& surface, RetriangulationCost cost)
    : rows_(&rows), cost_(cost), intervals_(surface.slot_count() * width()) {
    if (!rows.multipliers().vary()) return;
    const auto multiplier = [&](std::uint32_t h) { return rows.multipliers().at(surface.origin(h)); };
    for (std::uint32_t slot = 0; slot < surface.slot_count(); ++slot)
        least_.push_back(std::min({multiplier(3 * slot), multiplier(3 * slot + 1), multiplier(3 * slot + 2)}));
}

std::unique_ptr<RemovalErrorModel> Propagation::make_removal_model() {
    return std::make_unique<PropagatedRemoval>(*rows_, intervals_, least_, cost_);
}

/// Other variables may be free, so components may be in other columns, too.
void Propagation::set_bounds(const Rows& rows) {
    const std::size_t slots = intervals_.size() / width(), old_width = width(), new_width = to_index(rows.width()) + 1;
    std::vector<ErrorInterval> intervals(slots * new_width);
    const auto scale = [&](std::size_t from, std::size_t to, double ratio) {
        for (std::size_t slot = 0; slot < slots; ++slot) {
            const ErrorInterval& old = intervals_[slot * old_width + from];
            intervals[slot * new_width + to] = {old.lowest * ratio, old.highest * ratio};
        }
    };
    for (std::size_t n = 0; n < rows.groups().size(); ++n) {
        const RowGroup &before = rows_->groups()[n], &after = rows.groups()[n];
        const double ratio = rows_->unit(before) / rows.unit(after);
        for (int i = 0; i < after.count; ++i) scale(to_index(before.first + i), to_index(after.first + i), ratio);
        if (after.variable == 0) scale(old_width - 1, new_width - 1, ratio); // the signed distance
    }
    intervals_ = std::move(intervals);
    rows_ = &rows;
}

void Propagation::errors(std::uint32_t slot, std::vector<ErrorRange>& ranges) const {
    const ErrorInterval* intervals = &intervals_[slot * width()];
    ranges.clear();
    for (const RowGroup& group : rows_->groups()) {
        double square = 0;
        for (int i = group.first; i < group.first + group.count; ++i)
            square += intervals[i].magnitude() * intervals[i].magnitude();
        const ErrorInterval& sign = group.variable == 0 ? intervals[rows_->width()] : intervals[group.first];
        const double largest = std::sqrt(square);
        // Intervals cannot hold NaN: of such a variable nothing is known anywhere.
        ranges.push_back(
            {largest, least_.empty() ? largest : largest / least_[slot], sign.lowest, sign.highest, group.finite});
    }
}

} // namespace meshbound
