#include "self_intersection/piercing.hpp"

#include <algorithm>
#include <utility>

#include "util/indexing.hpp"
#include "geometry/places.hpp"
#include "mesh/scaled_points.hpp"

namespace meshbound {
namespace {

/// The largest coordinate is brought to this power of two. Products of three stay below the largest double, and those of
/// the smallest differences above the smallest one, as long as no coordinate but 0 is below 1e-150 of the largest.
constexpr int scaled_exponent = 300;

/// Whether two of the corners are at one place: then there is nothing to it but an edge, which its neighbours have too.
bool collapsed(const PlacedTriangle& triangle) {
    const auto& [a, b, c] = triangle.places;
    return a == b || b == c || c == a;
}

BoundingBox box_of(const PlacedTriangle& triangle) {
    BoundingBox box;
    if (collapsed(triangle)) return box; // is never found
    for (const glm::dvec3& point : triangle.points) box.include(point);
    return box;
}

} // namespace

Piercing::Piercing(const Mesh& mesh, const Surface& surface)
    : surface_(surface), points_(scaled_points(mesh, scaled_exponent).points), places_(number_places(points_)) {
    build();
}

void Piercing::build() {
    std::vector<TriangleTree::Item> items;
    for (std::uint32_t slot = 0; slot < surface_.slot_count(); ++slot)
        if (surface_.alive(slot)) items.push_back({slot, box_of(placed(slot))});
    built_over_ = items.size();
    vanished_ = 0;
    tree_.build(std::move(items), surface_.slot_count());
}

void Piercing::tidy() {
    if (2 * vanished_ > built_over_) build();
}

PlacedTriangle Piercing::placed(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
    const std::uint32_t u = surface_.input(a), v = surface_.input(b), w = surface_.input(c);
    return {{places_[u], places_[v], places_[w]}, {points_[u], points_[v], points_[w]}};
}

PlacedTriangle Piercing::placed(std::uint32_t slot) const {
    return placed(surface_.origin(3 * slot), surface_.origin(3 * slot + 1), surface_.origin(3 * slot + 2));
}

PlacedTriangle Piercing::placed(const Hole& hole, const NewTriangle& triangle) const {
    return placed(hole.ring[at(triangle.a)], hole.ring[at(triangle.m)], hole.ring[at(triangle.b)]);
}

bool Piercing::pierces(const std::vector<Filling>& fillings) const {
    std::vector<Boxed> fresh;
    BoundingBox whole;
    for (const auto& [hole, retriangulation] : fillings)
        for (const NewTriangle& triangle : retriangulation->triangles) {
            const PlacedTriangle here = placed(*hole, triangle);
            if (collapsed(here)) continue;
            if (pierces(fresh, here)) return true;
            fresh.push_back({here, box_of(here)});
            for (const glm::dvec3& point : here.points) whole.include(point);
        }
    return tree_.any(whole, [&](std::uint32_t slot) {
        const std::uint32_t a = surface_.origin(3 * slot), b = surface_.origin(3 * slot + 1),
                            c = surface_.origin(3 * slot + 2);
        const auto has_corner = [&](const Filling& filling) {
            const std::uint32_t candidate = filling.hole->candidate;
            return a == candidate || b == candidate || c == candidate;
        };
        const bool vanishes = std::any_of(fillings.begin(), fillings.end(), has_corner);
        return !vanishes && pierces(fresh, placed(a, b, c));
    });
}

bool Piercing::pierces(const std::vector<Boxed>& fresh, const PlacedTriangle& other) {
    const BoundingBox box = box_of(other);
    return std::any_of(fresh.begin(), fresh.end(), [&](const Boxed& triangle) {
        return triangle.box.meets(box) && pierce(triangle.triangle, other);
    });
}

void Piercing::change(const Hole& hole, const Retriangulation& retriangulation) {
    const std::vector<NewTriangle>& fresh = retriangulation.triangles;
    for (std::size_t n = 0; n < hole.slots.size(); ++n)
        tree_.change(hole.slots[n], n < fresh.size() ? box_of(placed(hole, fresh[n])) : BoundingBox{});
    vanished_ += hole.slots.size() - fresh.size();
}

} // namespace meshbound
