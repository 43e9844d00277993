#include "geometry/point_ids.hpp"

#include <algorithm>
#include <numeric>
#include <tuple>

namespace meshbound {

std::vector<std::uint32_t> point_ids(const std::vector<glm::dvec3>& points) {
    std::vector<std::uint32_t> order(points.size()), ids(points.size());
    std::iota(order.begin(), order.end(), 0U);
    const auto key = [&](std::uint32_t vertex) {
        const glm::dvec3& p = points[vertex];
        return std::tuple(p.x, p.y, p.z);
    };
    std::sort(order.begin(), order.end(),
              [&](std::uint32_t v, std::uint32_t w) { return points[v] == points[w] ? v < w : key(v) < key(w); });
    for (std::size_t i = 0; i < order.size(); ++i) {
        const bool same = i > 0 && points[order[i]] == points[order[i - 1]];
        ids[order[i]] = same ? ids[order[i - 1]] : order[i];
    }
    return ids;
}

} // namespace meshbound
