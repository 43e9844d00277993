#include "metric/rows.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "mesh/used_vertices.hpp"
#include "metric/rounding_margin.hpp"

namespace meshbound {
namespace {

double unit_of(const ResolvedBound& bound) {
    if (std::isfinite(bound.absolute)) return bound.absolute;
    return bound.extent > 0 && std::isfinite(bound.extent) ? bound.extent : 1;
}

bool is_finite(const ResolvedBound& bound) { return bound.non_finite == 0 && std::isfinite(bound.extent); }

/// The middle between the lowest and the highest number that a component has where triangles are, so that rows can be
/// centred: a far offset must not cost precision.
double centre_of(const VariableView& variable, int component, const std::vector<char>& used) {
    double lowest = std::numeric_limits<double>::infinity(), highest = -lowest;
    for (std::size_t vertex = 0; vertex < used.size(); ++vertex) {
        if (!used[vertex]) continue;
        const double value = value_at(variable, vertex, component);
        if (!std::isfinite(value)) continue;
        lowest = std::min(lowest, value);
        highest = std::max(highest, value);
    }
    return lowest <= highest ? lowest + (highest - lowest) / 2 : 0;
}

void fill(const VariableView& variable, const RowGroup& group, double unit, std::size_t width,
          const std::vector<std::uint32_t>& inputs, const std::vector<char>& used, std::vector<double>& rows) {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    const std::size_t vertices = rows.size() / width;
    for (int component = 0; component < group.count; ++component) {
        const double centre = centre_of(variable, component, used);
        const auto column = static_cast<std::size_t>(group.first + component);
        for (std::size_t vertex = 0; vertex < vertices; ++vertex) {
            const std::size_t input = inputs.empty() ? vertex : inputs[vertex];
            if (!used[input]) continue;
            const double value = (value_at(variable, input, component) - centre) / unit;
            rows[vertex * width + column] = std::isfinite(value) ? value : nan;
        }
    }
}

} // namespace

/// Gives a group the next columns; a group of several components begins at an even one.
void Rows::append_group(RowGroup& group) {
    if (group.count > 1) width_ += width_ % 2;
    group.first = width_;
    width_ += group.count;
}

void Rows::arrange_groups() {
    std::vector<RowGroup*> scalars;
    for (RowGroup& group : groups_)
        if (group.bounded && group.count == 1) scalars.push_back(&group);
    auto next_scalar = scalars.begin();
    for (RowGroup& group : groups_) {
        if (group.count == 1 || !(group.bounded || group.variable == 0)) continue;
        append_group(group);
        if (group.bounded && width_ % 2 == 1 && next_scalar != scalars.end()) append_group(**next_scalar++);
        width_ += width_ % 2;
    }
    for (; next_scalar != scalars.end(); ++next_scalar) append_group(**next_scalar);
    width_ += width_ % 2;
    for (RowGroup& group : groups_)
        if (!group.bounded && group.variable != 0) append_group(group);
    width_ += width_ % 2;
}

Rows::Rows(const Mesh& mesh, const std::vector<ResolvedBound>& bounds, const Variable* bound_multiplier,
           const std::vector<std::uint32_t>& inputs)
    : multipliers_(mesh, bound_multiplier, inputs) {
    double margin = 0;
    for (std::uint32_t i = 0; i < bounds.size(); ++i) {
        const ResolvedBound& bound = bounds[i];
        groups_.push_back({0, variable_of(mesh, i).components, i, std::isfinite(bound.absolute), is_finite(bound)});
        units_.push_back(unit_of(bound));
        margin = std::max(margin, rounding_margin(bound));
    }
    arrange_groups();
    limit_ = 1 - margin / multipliers_.least();
    const std::vector<char> used = find_used_vertices(mesh);
    const std::size_t vertices = inputs.empty() ? vertex_count(mesh) : inputs.size();
    values_.resize(vertices * static_cast<std::size_t>(width_));
    for (const RowGroup& group : groups_)
        fill(variable_of(mesh, group.variable), group, unit(group), static_cast<std::size_t>(width_), inputs, used,
             values_);
}

double squared_ratio(const double* difference, const std::vector<RowGroup>& groups) {
    double worst = 0;
    for (const RowGroup& group : groups) {
        if (!group.bounded) continue;
        double square = 0;
        for (int i = group.first; i < group.first + group.count; ++i) square += difference[i] * difference[i];
        worst = std::max(worst, square);
    }
    return worst;
}

} // namespace meshbound
