#include "measured_rows.hpp"

namespace meshbound {

MeasuredRows::MeasuredRows(const Rows& rows) : rows_(&rows) {
    const std::vector<RowGroup>& groups = rows.groups();
    begin_ =
        groups.front().bounded ? 0 : groups.front().count + groups.front().count % 2; // position, which comes first
    const auto add_lanes = [this](int components) { return lanes_ += (components + 1) / 2; };
    for (const RowGroup& group : groups) {
        if (!group.bounded || group.count == 1) continue;
        const int first = lanes_;
        vectors_.push_back({first, add_lanes(group.count), group.variable});
    }
    scalars_ = lanes_;
    for (const RowGroup& group : groups)
        if (group.bounded && group.count == 1) scalar_variables_.push_back(group.variable);
    add_lanes(static_cast<int>(scalar_variables_.size()));
}

} // namespace meshbound
