#include "surface/one_sided.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "mesh/half_edges_by_edge.hpp"
#include "mesh/orientation.hpp"
#include "mesh/repeats_vertex.hpp"

namespace meshbound {
namespace {

using Corners = std::array<std::uint32_t, 3>;

Corners sorted_corners(const glm::uvec3& triangle) {
    Corners corners = {triangle.x, triangle.y, triangle.z};
    std::sort(corners.begin(), corners.end());
    return corners;
}

/// Of two triangles on the same three vertices.
bool same_winding(const glm::uvec3& one, const glm::uvec3& other) {
    for (int i = 0; i < 3; ++i)
        if (other[i] == one.x) return other[(i + 1) % 3] == one.y;
    return false;
}

/// The proper triangles with their vertices sorted: those on the same three are neighbours, in their order in the mesh.
std::vector<std::pair<Corners, std::uint32_t>> sort_triangles(const std::vector<glm::uvec3>& triangles) {
    std::vector<std::pair<Corners, std::uint32_t>> sorted;
    sorted.reserve(triangles.size());
    for (std::uint32_t t = 0; t < triangles.size(); ++t)
        if (!repeats_vertex(triangles[t])) sorted.emplace_back(sorted_corners(triangles[t]), t);
    std::sort(sorted.begin(), sorted.end());
    return sorted;
}

glm::uvec3 flipped(const glm::uvec3& triangle) { return {triangle.x, triangle.z, triangle.y}; }

/// By triangle of a sheet, the index of its front after both sides are restored.
std::vector<std::uint32_t> number_fronts(const SideLabels& labels, const std::vector<std::int32_t>& sides) {
    std::vector<std::uint32_t> fronts;
    std::uint32_t next = 0;
    for (const std::int32_t side : sides) {
        fronts.push_back(next);
        next += labels.two_sided(side) ? 2 : 1;
    }
    return fronts;
}

/// Repeats the value of each front for its back.
void repeat_for_backs(const SideLabels& labels, const std::vector<std::int32_t>& sides, std::vector<float>& values) {
    if (values.empty()) return;
    std::vector<float> both;
    for (std::size_t t = 0; t < sides.size(); ++t)
        both.insert(both.end(), labels.two_sided(sides[t]) ? 2 : 1, values[t]);
    values = std::move(both);
}

/// What lies outside of the front lies inside of the back.
void negate_signs(const SideLabels& labels, const std::vector<std::int32_t>& sides, TriangleErrors& errors) {
    if (errors.lowest.empty()) return;
    const std::vector<std::uint32_t> fronts = number_fronts(labels, sides);
    for (std::size_t t = 0; t < sides.size(); ++t) {
        if (!labels.two_sided(sides[t])) continue;
        const std::size_t back = fronts[t] + std::size_t{1};
        errors.lowest[back] = -errors.highest[fronts[t]];
        errors.highest[back] = -errors.lowest[fronts[t]];
    }
}

void renumber(const std::vector<std::uint32_t>& fronts, SurfaceMap& map) {
    for (SurfacePoint& place : map.images)
        if (place.triangle != nowhere) place.triangle = fronts[place.triangle];
}

} // namespace

std::int32_t SideLabels::number(std::int32_t front, std::optional<std::int32_t> back) {
    const auto next = static_cast<std::int32_t>(known_.size());
    const auto [found, is_new] = numbers_.try_emplace({front, back.has_value(), back.value_or(0)}, next);
    if (is_new) known_.push_back({front, back});
    return found->second;
}

OneSided::OneSided(const Mesh& mesh, Orienting orienting, SideLabels& labels)
    : in_shape_(mesh.triangles.size(), no_index) {
    shape_.position = mesh.position;
    find_sides(mesh);
    if (orienting == Orienting::as_reduced) orient_sides();
    const auto label = [&](std::uint32_t triangle) { return mesh.regions.empty() ? 0 : mesh.regions[triangle]; };
    for (std::size_t t = 0; t < fronts_.size(); ++t) {
        const bool two_sided = backs_[t] != no_index;
        shape_.regions.push_back(
            labels.number(label(fronts_[t]), two_sided ? std::optional(label(backs_[t])) : std::nullopt));
    }
}

void OneSided::find_sides(const Mesh& mesh) {
    const std::vector<glm::uvec3>& triangles = mesh.triangles;
    std::vector<std::uint32_t> first_of(triangles.size(), no_index), back_of(triangles.size(), no_index);
    const auto sorted = sort_triangles(triangles);
    for (std::size_t i = 0, first = 0; i < sorted.size(); ++i) {
        if (sorted[i].first != sorted[first].first) first = i;
        const std::uint32_t front = sorted[first].second, here = sorted[i].second;
        first_of[here] = front;
        if (here == front) continue;
        if (back_of[front] == no_index && !same_winding(triangles[front], triangles[here])) back_of[front] = here;
        else copies_.push_back(here);
    }
    std::sort(copies_.begin(), copies_.end());
    for (std::uint32_t t = 0; t < triangles.size(); ++t) {
        if (first_of[t] == no_index) continue;
        if (first_of[t] != t) {
            in_shape_[t] = in_shape_[first_of[t]]; // which came before
            continue;
        }
        in_shape_[t] = static_cast<std::uint32_t>(fronts_.size());
        fronts_.push_back(t);
        backs_.push_back(back_of[t]);
        shape_.triangles.push_back(triangles[t]);
    }
}

/// Of a two-sided triangle either side may be the front, so none is flipped: front and back are exchanged instead. Nor
/// can it be unorientable.
void OneSided::orient_sides() {
    std::vector<char> two_sided;
    for (const std::uint32_t back : backs_) two_sided.push_back(back != no_index);
    const Orientation orientation = orient(shape_.triangles, vertex_count(shape_), two_sided);
    flipped_ = orientation.flipped;
    unorientable_parts_ = orientation.unorientable_components;
    if (unorientable_parts_ > 0) unorientable_triangle_ = fronts_[orientation.unorientable_triangle];
    for (std::size_t t = 0; t < fronts_.size(); ++t)
        if (two_sided[t] && orientation.triangles[t] != shape_.triangles[t]) std::swap(fronts_[t], backs_[t]);
    shape_.triangles = orientation.triangles;
}

std::vector<std::uint8_t> OneSided::sides() const {
    std::vector<std::uint8_t> sides;
    for (const std::uint32_t back : backs_) sides.push_back(back == no_index ? 1 : 2);
    return sides;
}

void OneSided::note(MeshDefects& defects) const {
    defects.flipped_triangles = flipped_;
    defects.unorientable_components = unorientable_parts_;
    defects.unorientable_triangle = unorientable_triangle_;
    defects.copied_triangles = copies_.size();
    defects.two_sided_triangles =
        backs_.size() - static_cast<std::size_t>(std::count(backs_.begin(), backs_.end(), no_index));
}

bool has_coincident_triangles(const Mesh& mesh) {
    std::vector<std::uint32_t> origin;
    origin.reserve(3 * mesh.triangles.size());
    for (const glm::uvec3& triangle : mesh.triangles)
        if (!repeats_vertex(triangle)) origin.insert(origin.end(), {triangle.x, triangle.y, triangle.z});
    bool any = false;
    CoincidentTriangleSearch search(origin);
    HalfEdgesByEdge(origin, vertex_count(mesh)).for_each_edge([&](const std::uint32_t* run, std::size_t count) {
        any = any || search.finds(run, count);
    });
    return any;
}

void restore_both_sides(const SideLabels& labels, bool with_regions, Reduction& reduction, SurfaceMap* link) {
    const std::vector<std::int32_t> sides = std::move(reduction.mesh.regions);
    const std::vector<glm::uvec3> sheet = std::move(reduction.mesh.triangles);
    reduction.mesh.regions.clear();
    reduction.mesh.triangles.clear();
    for (std::size_t t = 0; t < sheet.size(); ++t) {
        reduction.mesh.triangles.push_back(sheet[t]);
        if (with_regions) reduction.mesh.regions.push_back(labels.front(sides[t]));
        if (!labels.two_sided(sides[t])) continue;
        reduction.mesh.triangles.push_back(flipped(sheet[t]));
        if (with_regions) reduction.mesh.regions.push_back(labels.back(sides[t]));
    }
    for (TriangleErrors& errors : reduction.triangle_errors)
        for (auto* values : {&errors.largest, &errors.ratio, &errors.lowest, &errors.highest})
            repeat_for_backs(labels, sides, *values);
    if (!reduction.triangle_errors.empty()) negate_signs(labels, sides, reduction.triangle_errors[0]);
    const std::vector<std::uint32_t> fronts = number_fronts(labels, sides);
    renumber(fronts, reduction.map);
    if (link) renumber(fronts, *link);
}

} // namespace meshbound
