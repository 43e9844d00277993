#include "metric/bounded_rows.hpp"

namespace meshbound {

/// By the order of columns that Rows documents.
BoundedRows::BoundedRows(const Rows& rows) : rows_(&rows) {
    const std::vector<RowGroup>& groups = rows.groups();
    begin_ =
        groups.front().bounded ? 0 : groups.front().count + groups.front().count % 2; // position, which comes first
    const auto lane_of = [this](const RowGroup& group) { return (group.first - begin_) / 2; };
    for (const RowGroup& group : groups)
        if (group.bounded && group.count > 1)
            vectors_.push_back(
                {lane_of(group), lane_of(group) + group.count / 2, group.count % 2 == 1, group.variable});
    for (const Vector& vector : vectors_) lanes_ = std::max(lanes_, vector.full_end + (vector.odd ? 1 : 0));
    scalars_ = lanes_;
    for (const RowGroup& group : groups) {
        if (!group.bounded || group.count > 1) continue;
        if (lane_of(group) < scalars_) vector_sharing(lane_of(group)).scalar = group.variable;
        else scalar_variables_.push_back(group.variable);
    }
    lanes_ += (static_cast<int>(scalar_variables_.size()) + 1) / 2;
    if (lanes_ == 0) return;
    begin_prefetched_ = begin_;
    end_prefetched_ = begin_ + std::min(2 * lanes_ - 1, 8);
}

/// The vector whose last component has half of this lane.
BoundedRows::Vector& BoundedRows::vector_sharing(int lane) {
    return *std::find_if(vectors_.begin(), vectors_.end(),
                         [lane](const Vector& vector) { return vector.odd && vector.full_end == lane; });
}

/// How many variables are bounded, position among them.
double BoundedRows::variables() const {
    const auto scalars = std::count_if(vectors_.begin(), vectors_.end(),
                                       [](const Vector& vector) { return vector.scalar != no_variable; });
    return static_cast<double>(vectors_.size() + scalar_variables_.size()) + static_cast<double>(scalars);
}

} // namespace meshbound
