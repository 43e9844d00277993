#include "measured_rows.hpp"

namespace meshbound {

MeasuredRows::MeasuredRows(const Rows& rows, std::size_t vertices) : multipliers_(&rows.multipliers()) {
    std::vector<int> source; // by packed component: component of the full row, or -1 for padding
    const auto pad = [&] {
        if (source.size() % 2) source.push_back(-1);
    };
    const auto lanes = [&] { return static_cast<int>(source.size() / 2); };
    for (const RowGroup& group : rows.groups()) {
        if (!group.bounded || group.count == 1) continue;
        const int first = lanes();
        for (int i = 0; i < group.count; ++i) source.push_back(group.first + i);
        pad();
        vectors_.push_back({first, lanes(), group.variable});
    }
    scalars_ = lanes();
    for (const RowGroup& group : rows.groups()) {
        if (!group.bounded || group.count != 1) continue;
        source.push_back(group.first);
        scalar_variables_.push_back(group.variable);
    }
    pad();
    lanes_ = lanes();
    values_.resize(vertices * source.size());
    for (std::size_t vertex = 0; vertex < vertices; ++vertex)
        for (std::size_t i = 0; i < source.size(); ++i)
            values_[vertex * source.size() + i] =
                source[i] < 0 ? 0 : rows[static_cast<std::uint32_t>(vertex)][source[i]];
}

} // namespace meshbound
