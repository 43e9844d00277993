#include "self_intersection/self_intersection_check.hpp"

#include <algorithm>
#include <utility>

#include "geometry/point_ids.hpp"
#include "mesh/scaled_points.hpp"
#include "util/indexing.hpp"

namespace meshbound {
namespace {

/// The largest coordinate is brought to this power of two. Products of three stay below the largest double, and those of
/// the smallest differences above the smallest one, as long as no coordinate but 0 is below 1e-150 of the largest.
constexpr int scaled_exponent = 300;

/// Whether two corners coincide: then the triangle is no more than an edge, which its neighbours have, too.
bool is_degenerate(const SpatialTriangle& triangle) {
    const auto& [a, b, c] = triangle.ids;
    return a == b || b == c || c == a;
}

BoundingBox box_of(const SpatialTriangle& triangle) {
    BoundingBox box;
    if (is_degenerate(triangle)) return box; // is never found
    for (const glm::dvec3& point : triangle.points) box.include(point);
    return box;
}

} // namespace

SelfIntersectionCheck::SelfIntersectionCheck(const Mesh& mesh, const Surface& surface)
    : surface_(surface), points_(scaled_points(mesh, scaled_exponent).points), ids_(point_ids(points_)) {
    build();
}

void SelfIntersectionCheck::build() {
    std::vector<AabbTree::Item> items;
    for (std::uint32_t slot = 0; slot < surface_.slot_count(); ++slot)
        if (surface_.alive(slot)) items.push_back({slot, box_of(spatial_triangle(slot))});
    built_over_ = items.size();
    removed_ = 0;
    tree_.build(std::move(items), surface_.slot_count());
}

void SelfIntersectionCheck::rebuild_if_sparse() {
    if (2 * removed_ > built_over_) build();
}

SpatialTriangle SelfIntersectionCheck::spatial_triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
    const std::uint32_t u = surface_.input(a), v = surface_.input(b), w = surface_.input(c);
    return {{ids_[u], ids_[v], ids_[w]}, {points_[u], points_[v], points_[w]}};
}

SpatialTriangle SelfIntersectionCheck::spatial_triangle(std::uint32_t slot) const {
    return spatial_triangle(surface_.origin(3 * slot), surface_.origin(3 * slot + 1), surface_.origin(3 * slot + 2));
}

SpatialTriangle SelfIntersectionCheck::spatial_triangle(const Hole& hole, const NewTriangle& triangle) const {
    return spatial_triangle(hole.ring[to_index(triangle.a)], hole.ring[to_index(triangle.m)],
                            hole.ring[to_index(triangle.b)]);
}

bool SelfIntersectionCheck::self_intersects(const std::vector<Filling>& fillings) const {
    std::vector<Boxed> fresh;
    BoundingBox whole;
    for (const auto& [hole, retriangulation] : fillings)
        for (const NewTriangle& triangle : retriangulation->triangles) {
            const SpatialTriangle here = spatial_triangle(*hole, triangle);
            if (is_degenerate(here)) continue;
            if (self_intersects(fresh, here)) return true;
            fresh.push_back({here, box_of(here)});
            for (const glm::dvec3& point : here.points) whole.include(point);
        }
    return tree_.any_overlapping(whole, [&](std::uint32_t slot) {
        const std::uint32_t a = surface_.origin(3 * slot), b = surface_.origin(3 * slot + 1),
                            c = surface_.origin(3 * slot + 2);
        const auto has_corner = [&](const Filling& filling) {
            const std::uint32_t candidate = filling.hole->candidate;
            return a == candidate || b == candidate || c == candidate;
        };
        const bool vanishes = std::any_of(fillings.begin(), fillings.end(), has_corner);
        return !vanishes && self_intersects(fresh, spatial_triangle(a, b, c));
    });
}

bool SelfIntersectionCheck::self_intersects(const std::vector<Boxed>& fresh, const SpatialTriangle& other) {
    const BoundingBox box = box_of(other);
    return std::any_of(fresh.begin(), fresh.end(), [&](const Boxed& triangle) {
        return triangle.box.overlaps(box) && intersect_beyond_shared(triangle.triangle, other);
    });
}

void SelfIntersectionCheck::update(const Hole& hole, const Retriangulation& retriangulation) {
    const std::vector<NewTriangle>& fresh = retriangulation.triangles;
    for (std::size_t n = 0; n < hole.slots.size(); ++n)
        tree_.update(hole.slots[n], n < fresh.size() ? box_of(spatial_triangle(hole, fresh[n])) : BoundingBox{});
    removed_ += hole.slots.size() - fresh.size();
}

} // namespace meshbound
