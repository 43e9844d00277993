#include "legality.hpp"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "layout.hpp"

namespace meshbound {
namespace {

/// A hole with more corners is left alone: the dynamic programme grows with the cube, and such hubs shrink as their
/// neighbours go.
constexpr int largest_ring = 48;

/// New triangles that must keep to the hole's normal do so within this cosine (about 84°): beyond, they turn away.
constexpr double least_turn_cosine = 0.1;

/// Across an edge the surface may bend to this cosine (120°), or as far as it bent anywhere in the star before, whichever is
/// more (a crease may move); beyond, it folds onto itself. Negative.
constexpr double sharpest_bend_cosine = -0.5;

/// A laid-out triangle with less than this fraction of the hole's squared size is degenerate.
constexpr double least_area = 1e-9;

glm::dvec3 area_vector(const glm::dvec3& p, const glm::dvec3& q, const glm::dvec3& r) {
    return glm::cross(q - p, r - p);
}

/// Cosine between two vectors where it is negative, else 0 (as almost always; then no root is needed). A triangle without
/// area folds onto nothing.
double negative_cosine(const glm::dvec3& a, const glm::dvec3& b) {
    const double product = glm::dot(a, b);
    return product < 0 ? product / std::sqrt(glm::dot(a, a) * glm::dot(b, b)) : 0;
}

std::size_t at(int i) { return static_cast<std::size_t>(i); }

} // namespace

Legality::Legality(const Surface& surface, bool minds_turns)
    : minds_turns_(minds_turns), ring_position_(surface.vertex_count(), -1) {}

bool Legality::enter(const Surface& surface, const Rows& rows, const Hole& hole) {
    rows_ = &rows;
    hole_ = &hole;
    if (!removable(surface, hole)) return false;
    find_taken_edges(surface, hole);
    if (hole.open && taken_[at(hole.size() - 1)]) return false; // the closing edge exists: the loop has three edges
    normal_ = star_normal(rows, hole);
    find_neighbours(surface, rows, hole);
    least_bend_cosine_ = std::min(sharpest_bend_cosine, sharpest_bend(rows, hole));
    scale_ = 0;
    for (const glm::dvec2& place : hole.places) scale_ = std::max(scale_, glm::dot(place, place));
    return true;
}

bool Legality::removable(const Surface& surface, const Hole& hole) const {
    if (hole.size() < 3 || hole.size() > largest_ring) return false;
    if (hole.size() > 3 || hole.open) return true;
    for (int rim = 0; rim < 3; ++rim) { // a ring of three: does its triangle exist on the other side?
        const std::uint32_t across = surface.twin(hole.rims[at(rim)]);
        if (across != no_index && surface.target(Surface::next(across)) == hole.ring[at((rim + 2) % 3)]) return false;
    }
    return true;
}

/// Ring vertices joined by an edge that is neither rim nor spoke: found by walking around each of them.
void Legality::find_taken_edges(const Surface& surface, const Hole& hole) {
    const int size = hole.size();
    taken_.assign(at(size * size), 0);
    const auto take = [&](int i, int j) { taken_[at(i * size + j)] = taken_[at(j * size + i)] = 1; };
    for (int i = 0; i < size; ++i) ring_position_[hole.ring[at(i)]] = i;
    for (int i = 0; i < size; ++i) {
        const std::uint32_t vertex = hole.ring[at(i)];
        if (surface.kind(vertex) == VertexKind::fixed) {
            for (int j = 0; j < i; ++j)
                if (surface.fixed_edge_exists(vertex, hole.ring[at(j)])) take(i, j);
            continue;
        }
        const std::uint32_t first = surface.outgoing(vertex);
        std::uint32_t spoke = first;
        do {
            if (const int j = ring_position_[surface.target(spoke)]; j >= 0) take(i, j);
            const std::uint32_t arriving = Surface::previous(spoke);
            if (const int j = ring_position_[surface.origin(arriving)]; j >= 0) take(i, j);
            spoke = surface.twin(arriving);
        } while (spoke != no_index && spoke != first);
    }
    for (const std::uint32_t vertex : hole.ring) ring_position_[vertex] = -1;
}

void Legality::find_neighbours(const Surface& surface, const Rows& rows, const Hole& hole) {
    neighbours_.assign(at(hole.sectors()), glm::dvec3(0));
    for (int i = 0; i < hole.sectors(); ++i) {
        const std::uint32_t twin = surface.twin(hole.rims[at(i)]);
        if (twin == no_index) continue;
        const glm::dvec3 p = rows.position(surface.origin(twin)), q = rows.position(surface.target(twin));
        neighbours_[at(i)] = area_vector(p, q, rows.position(surface.target(Surface::next(twin))));
    }
}

/// The least cosine across the star's spokes and rims, as the surface is now; 0 where all are positive.
double Legality::sharpest_bend(const Rows& rows, const Hole& hole) const {
    const auto sector = [&](int i) {
        return area_vector(rows.position(hole.candidate), rows.position(hole.ring[at(i)]),
                           rows.position(hole.ring[at(hole.after(i))]));
    };
    double least = 0;
    glm::dvec3 before = hole.open ? glm::dvec3(0) : sector(hole.sectors() - 1);
    for (int i = 0; i < hole.sectors(); ++i) {
        const glm::dvec3 here = sector(i);
        least = std::min({least, negative_cosine(before, here), negative_cosine(here, neighbours_[at(i)])});
        before = here;
    }
    return least;
}

glm::dvec3 Legality::normal(int a, int m, int b) const {
    const auto position = [&](int i) { return rows_->position(hole_->ring[at(i)]); };
    return area_vector(position(a), position(m), position(b));
}

bool Legality::allows_edge(int i, int j) const {
    const int size = hole_->size();
    if (j == i + 1 || (i == 0 && j == size - 1)) return true;
    if (taken_[at(i * size + j)]) return false;
    // The candidate of an open hole goes to the closing edge, so every diagonal must leave it on that side.
    return !hole_->open || orientation(hole_->places[at(i)], hole_->places[at(j)], glm::dvec2(0)) >= 0;
}

/// Whether two triangles beside an edge, given by their normals, bend too far there.
bool Legality::folds(const glm::dvec3& p, const glm::dvec3& q) const {
    return negative_cosine(p, q) < least_bend_cosine_;
}

bool Legality::folds_onto_neighbour(const glm::dvec3& normal, int rim) const {
    if (rim >= hole_->sectors()) return false; // the closing edge of an open hole
    return folds(neighbours_[at(rim)], normal);
}

bool Legality::allows_triangle(int a, int m, int b) const {
    const Hole& hole = *hole_;
    if (orientation(hole.places[at(a)], hole.places[at(m)], hole.places[at(b)]) <= least_area * scale_) return false;
    const glm::dvec3 here = normal(a, m, b);
    if (minds_turns_ && glm::dot(here, normal_) < least_turn_cosine * glm::length(here) * glm::length(normal_))
        return false;
    if (m == a + 1 && folds_onto_neighbour(here, a)) return false;
    if (b == m + 1 && folds_onto_neighbour(here, m)) return false;
    return !(a == 0 && b == hole.size() - 1 && folds_onto_neighbour(here, b));
}

bool Legality::allows_neighbours(int a, int m, int b, int left, int right) const {
    if (minds_turns_) return true; // keeping to one normal, they keep to each other
    const glm::dvec3 here = normal(a, m, b);
    return (left < 0 || !folds(here, normal(a, left, m))) && (right < 0 || !folds(here, normal(m, right, b)));
}

} // namespace meshbound
