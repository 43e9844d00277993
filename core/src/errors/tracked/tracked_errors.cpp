#include "errors/tracked/tracked_errors.hpp"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

namespace meshbound {

/// Calls `visit(original, reduced, multiplier)`, with two rows and the multiplier of the bounds, for every corner of
/// the map in a triangle: the vertices mapped into it, and the crossings and vertices on its edges.
template <class Visit>
void TrackedErrors::for_each_corner(std::uint32_t slot, const Visit& visit) const {
    std::vector<double> original(to_index(rows_.width())), reduced(to_index(rows_.width()));
    const double* corner[3];
    for (std::uint32_t i = 0; i < 3; ++i) corner[i] = rows_[surface_.origin(3 * slot + i)];
    const auto mix = [&](std::vector<double>& out, const double* p, const double* q, double share) {
        for (std::size_t i = 0; i < out.size(); ++i) out[i] = p[i] + share * (q[i] - p[i]);
    };
    for (std::uint32_t v = map_.mapped_vertices.in_triangle(slot); v != no_index; v = map_.mapped_vertices.next(v)) {
        const glm::dvec3 w = map_.mapped_vertices.barycentric(v);
        for (std::size_t i = 0; i < reduced.size(); ++i)
            reduced[i] = w.x * corner[0][i] + w.y * corner[1][i] + w.z * corner[2][i];
        visit(rows_[v], reduced.data(), rows_.multipliers().at(v));
    }
    for (std::uint32_t h = 3 * slot; h < 3 * slot + 3; ++h) {
        const double* lower = rows_[std::min(surface_.origin(h), surface_.target(h))];
        const double* upper = rows_[std::max(surface_.origin(h), surface_.target(h))];
        for (std::uint32_t v = map_.mapped_vertices.on_edge(surface_.edge(h)); v != no_index;
             v = map_.mapped_vertices.next(v)) {
            mix(reduced, lower, upper, map_.mapped_vertices.share(v));
            visit(rows_[v], reduced.data(), rows_.multipliers().at(v));
        }
        for (std::uint32_t id = map_.crossings.on(surface_.edge(h)); id != no_index; id = map_.crossings[id].sibling) {
            const Crossing& crossing = map_.crossings[id];
            const std::uint32_t start = map_.edges.lower(crossing.original), end = map_.edges.upper(crossing.original);
            mix(original, rows_[start], rows_[end], crossing.s);
            mix(reduced, lower, upper, crossing.t);
            visit(original.data(), reduced.data(), rows_.multipliers().between(start, end, crossing.s));
        }
    }
}

/// Whether a variable has numbers at all corners of a triangle, and so all over it.
bool TrackedErrors::has_numbers(std::uint32_t slot, const RowGroup& group) const {
    if (group.finite) return true;
    for (std::uint32_t h = 3 * slot; h < 3 * slot + 3; ++h)
        for (int i = group.first; i < group.first + group.count; ++i)
            if (std::isnan(rows_[surface_.origin(h)][i])) return false;
    return true;
}

void TrackedErrors::on_triangle(std::uint32_t slot, std::vector<ErrorRange>& ranges) const {
    ranges.assign(rows_.groups().size(), {});
    for (const RowGroup& group : rows_.groups()) ranges[group.variable].known = has_numbers(slot, group);
    const auto position = [&](std::uint32_t i) { return rows_.position(surface_.origin(3 * slot + i)); };
    const glm::dvec3 area = glm::cross(position(1) - position(0), position(2) - position(0));
    const glm::dvec3 normal = glm::length(area) > 0 ? glm::normalize(area) : area;
    for_each_corner(slot, [&](const double* original, const double* reduced, double multiplier) {
        for (const RowGroup& group : rows_.groups()) {
            double square = 0, sign = 0;
            for (int i = group.first; i < group.first + group.count; ++i) {
                const double difference = original[i] - reduced[i];
                square += difference * difference;
                sign += group.variable == 0 ? -difference * normal[i] : difference;
            }
            ErrorRange& range = ranges[group.variable];
            range.known = range.known && !std::isnan(square);
            range.largest = std::max(range.largest, std::sqrt(square));
            range.ratio = std::max(range.ratio, std::sqrt(square) / multiplier);
            range.lowest = std::min(range.lowest, sign);
            range.highest = std::max(range.highest, sign);
        }
    });
}

} // namespace meshbound
