#include "mesh/region_report.hpp"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "mesh/scaled_points.hpp"

namespace meshbound {
namespace {

/// So that the square of an area stays within what a double holds, whatever the unit is.
constexpr int scaled_exponent = 100;

/// Calls `add(triangle, region, area)` for every triangle. Regions are in the order of their labels, and all there.
template <class Add>
void for_each_triangle(const Mesh& mesh, std::vector<RegionReport>& regions, const Add& add) {
    const ScaledPoints scaled = scaled_points(mesh, scaled_exponent);
    const auto below = [](const RegionReport& region, std::int32_t label) { return region.label < label; };
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const glm::uvec3& triangle = mesh.triangles[t]; // one with a vertex twice has no area, wherever that is
        const glm::dvec3& corner = scaled.points[triangle.x];
        const double doubled =
            glm::length(glm::cross(scaled.points[triangle.y] - corner, scaled.points[triangle.z] - corner));
        add(t, *std::lower_bound(regions.begin(), regions.end(), mesh.regions[t], below),
            std::ldexp(doubled, -1 - 2 * scaled.exponent));
    }
}

} // namespace

std::vector<RegionReport> report_regions(const Mesh& before, const std::vector<std::uint32_t>& copies,
                                         const Mesh& after) {
    std::vector<std::int32_t> labels = before.regions;
    std::sort(labels.begin(), labels.end());
    labels.erase(std::unique(labels.begin(), labels.end()), labels.end());
    std::vector<RegionReport> regions;
    regions.reserve(labels.size());
    for (const std::int32_t label : labels) regions.push_back({label});
    for_each_triangle(before, regions, [&](std::size_t triangle, RegionReport& region, double area) {
        ++region.triangles_before;
        if (!std::binary_search(copies.begin(), copies.end(), triangle)) region.area_before += area;
    });
    for_each_triangle(after, regions, [](std::size_t, RegionReport& region, double area) {
        ++region.triangles_after;
        region.area_after += area;
    });
    return regions;
}

} // namespace meshbound
