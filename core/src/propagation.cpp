#include "propagation.hpp"

#include <algorithm>
#include <cmath>

#include "propagated_removal.hpp"

namespace meshbound {

Propagation::Propagation(const Rows& rows, const Surface& surface, Cost cost)
    : rows_(&rows), charged_(cost), intervals_(surface.slot_count() * width()) {
    if (!rows.multipliers().vary()) return;
    const auto multiplier = [&](std::uint32_t h) { return rows.multipliers().at(surface.origin(h)); };
    for (std::uint32_t slot = 0; slot < surface.slot_count(); ++slot)
        least_.push_back(std::min({multiplier(3 * slot), multiplier(3 * slot + 1), multiplier(3 * slot + 2)}));
}

std::unique_ptr<RemovalAccounting> Propagation::removals() {
    return std::make_unique<PropagatedRemoval>(*rows_, intervals_, least_, charged_);
}

void Propagation::measure_in(const Rows& rows) {
    std::vector<double> scale(width());
    for (std::size_t n = 0; n < rows.groups().size(); ++n) {
        const RowGroup& group = rows.groups()[n];
        const double ratio = rows_->unit(group) / rows.unit(group);
        for (int i = group.first; i < group.first + group.count; ++i) scale[static_cast<std::size_t>(i)] = ratio;
        if (group.variable == 0) scale.back() = ratio; // the signed distance
    }
    for (std::size_t i = 0; i < intervals_.size(); ++i) {
        intervals_[i].lowest *= scale[i % width()];
        intervals_[i].highest *= scale[i % width()];
    }
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
        ranges.push_back({largest, least_.empty() ? largest : largest / least_[slot], sign.lowest, sign.highest});
    }
}

} // namespace meshbound
