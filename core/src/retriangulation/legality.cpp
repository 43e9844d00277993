#include "retriangulation/legality.hpp"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "util/indexing.hpp"
#include "retriangulation/layout.hpp"
#include "geometry/plane.hpp"

namespace meshbound {
namespace {

/// New triangles that must keep to the hole's normal do so within this cosine (about 84°): beyond, they turn away.
constexpr double least_turn_cosine = 0.1;

/// Across an edge the surface may bend to this cosine (120°), or as far as it bent anywhere in the star before, whichever is
/// more (a crease may move); beyond, it folds onto itself. Negative.
constexpr double sharpest_bend_cosine = -0.5;

/// A laid-out triangle with less than this fraction of the hole's squared size is degenerate.
constexpr double least_area = 1e-9;

/// Cosine between two vectors where it is negative, else 0 (as almost always; then no root is needed). A triangle without
/// area folds onto nothing.
double negative_cosine(const glm::dvec3& a, const glm::dvec3& b) {
    const double product = glm::dot(a, b);
    return product < 0 ? product / std::sqrt(glm::dot(a, a) * glm::dot(b, b)) : 0;
}

} // namespace

bool Legality::enter(const Surface& surface, const Rows& rows, const Hole& hole) {
    hole_ = &hole;
    if (!removable(surface, hole)) return false;
    surface_ = &surface;
    taken_.assign(at(hole.size() * hole.size()), Taken::unknown);
    if (surface.has_sites()) find_taken_edges(surface, hole);
    if (touches_own_site(surface, hole)) return false;
    if (hole.open && is_taken(0, hole.size() - 1)) return false; // the closing edge exists: the loop has three edges
    if (minds_turns_) keep_to(star_normal(hole));
    find_directions(hole);
    find_neighbours(surface, rows, hole);
    double squared_size = 0;
    for (const glm::dvec2& place : hole.places) squared_size = std::max(squared_size, glm::dot(place, place));
    least_area_ = least_area * squared_size;
    return true;
}

bool Legality::removable(const Surface& surface, const Hole& hole) const {
    if (hole.size() < 3) return false;
    if (hole.size() > 3 || hole.open) return true;
    for (int rim = 0; rim < 3; ++rim) { // a ring of three: does its triangle exist on the other side?
        const std::uint32_t across = surface.twin(hole.rims[at(rim)]);
        if (across != no_index && surface.target(Surface::next(across)) == hole.ring[at((rim + 2) % 3)]) return false;
    }
    return !surface.has_sites() || !surface.triangle_exists(hole.ring[0], hole.ring[1], hole.ring[2]);
}

/// Ring vertices joined by an edge that is neither rim nor spoke: found by walking around each of them, on every sheet where
/// it has a copy, since sheets are to touch nowhere but where they do.
void Legality::find_taken_edges(const Surface& surface, const Hole& hole) {
    std::fill(taken_.begin(), taken_.end(), Taken::no);
    ring_filter_ = 0;
    sites_.clear();
    for (const std::uint32_t vertex : hole.ring) sites_.push_back(surface.site(vertex));
    for (const std::uint32_t site : sites_) ring_filter_ |= std::uint64_t{1} << (site % 64);
    for (int i = 0; i < hole.size(); ++i) {
        const auto see_neighbour = [&](std::uint32_t neighbour) {
            see(surface.site(neighbour), i);
            return true;
        };
        surface.for_each_in_site(hole.ring[at(i)],
                                 [&](std::uint32_t vertex) { surface.all_of_ring(vertex, see_neighbour); });
        see(sites_[at(i)], i); // no edge joins two copies of one vertex
    }
}

/// Of ring positions that are no neighbours on the ring.
bool Legality::is_taken(int i, int j) {
    Taken& taken = taken_[at(i * hole_->size() + j)];
    if (taken == Taken::unknown) {
        const std::uint32_t end = hole_->ring[at(j)];
        const auto is_other = [&](std::uint32_t neighbour) { return neighbour != end; };
        taken = surface_->all_of_ring(hole_->ring[at(i)], is_other) ? Taken::no : Taken::yes;
    }
    return taken == Taken::yes;
}

bool Legality::allows_diagonals(const Retriangulation& retriangulation) {
    bool all = true;
    for (const NewTriangle& triangle : retriangulation.triangles)
        if (triangle.parent >= 0 && is_taken(triangle.a, triangle.b)) all = false;
    return all;
}

/// The edge from ring position i to every ring position that is a copy of the site is taken.
void Legality::see(std::uint32_t site, int i) {
    if (!(ring_filter_ >> (site % 64) & 1)) return;
    for (int j = 0; j < hole_->size(); ++j)
        if (sites_[at(j)] == site) take(i, j);
}

/// Whether an edge of the input joins two vertices of the candidate's site: their stars overlap, and cannot go at once.
bool Legality::touches_own_site(const Surface& surface, const Hole& hole) const {
    return surface.has_sites() && std::find(sites_.begin(), sites_.end(), surface.site(hole.candidate)) != sites_.end();
}

void Legality::take(int i, int j) {
    taken_[at(i * hole_->size() + j)] = taken_[at(j * hole_->size() + i)] = Taken::yes;
}

void Legality::keep_to(const glm::dvec3& normal) {
    const double length = glm::length(normal);
    normal_ = length > 0 ? normal / length : normal;
    least_cosine_ = length > 0 ? least_turn_cosine : 0; // from no direction nothing turns away
}

void Legality::find_directions(const Hole& hole) {
    directions_.clear();
    for (const std::uint32_t vertex : hole.ring) directions_.push_back(original_.direction(vertex));
}

void Legality::find_neighbours(const Surface& surface, const Rows& rows, const Hole& hole) {
    neighbours_.assign(at(hole.sectors()), glm::dvec3(0));
    for (int i = 0; i < hole.sectors(); ++i) {
        const std::uint32_t twin = surface.twin(hole.rims[at(i)]);
        if (twin == no_index) continue;
        const glm::dvec3 &p = hole.positions[at(i)],
                         &q = hole.positions[at(hole.after(i))]; // the twin runs from q to p
        const glm::dvec3 tip = rows.position(surface.target(Surface::next(twin)));
        neighbours_[at(i)] = glm::cross(p - q, tip - q);
    }
}

/// The least cosine across the star's spokes and rims, as the surface is now; 0 where all are positive.
double Legality::sharpest_bend() const {
    const Hole& hole = *hole_;
    const auto sector = [&](int i) { return glm::cross(hole.spokes[at(i)], hole.spokes[at(hole.after(i))]); };
    double least = 0;
    glm::dvec3 before = hole.open ? glm::dvec3(0) : sector(hole.sectors() - 1);
    for (int i = 0; i < hole.sectors(); ++i) {
        const glm::dvec3 here = sector(i);
        least = std::min({least, negative_cosine(before, here), negative_cosine(here, neighbours_[at(i)])});
        before = here;
    }
    return least;
}

/// The candidate of an open hole goes to the closing edge, so every diagonal must leave it on that side.
bool Legality::leaves_candidate(int i, int j) const {
    return orientation(hole_->places[at(i)], hole_->places[at(j)], glm::dvec2(0)) >= 0;
}

/// Whether two triangles beside an edge, given by their normals, bend too far there.
bool Legality::folds(const glm::dvec3& p, const glm::dvec3& q) const {
    const double cosine = negative_cosine(p, q); // few are so small that the star is asked how far it bent
    return cosine < sharpest_bend_cosine && cosine < sharpest_bend();
}

bool Legality::folds_onto_neighbour(const RingTriangle& triangle, int rim) const {
    if (rim >= hole_->sectors()) return false; // the closing edge of an open hole
    return folds(neighbours_[at(rim)], triangle.normal);
}

bool Legality::allows_triangle(const RingTriangle& triangle) const {
    const auto& [a, m, b, u, v, w, normal, length] = triangle;
    if (minds_turns_ && glm::dot(normal, normal_) < least_cosine_ * length) return false;
    if (m == a + 1 && folds_onto_neighbour(triangle, a)) return false;
    if (b == m + 1 && folds_onto_neighbour(triangle, m)) return false;
    if (a == 0 && b == hole_->size() - 1 && folds_onto_neighbour(triangle, b)) return false;
    return !turns_from_original(triangle);
}

/// More than a right angle against the original, and more than any triangle that the original has at its corners.
bool Legality::turns_from_original(const RingTriangle& triangle) const {
    const auto& [a, m, b, u, v, w, normal, length] = triangle;
    const glm::dvec3 mean = directions_[at(a)] + directions_[at(m)] + directions_[at(b)];
    const double product = glm::dot(mean, normal);
    if (!(product < 0)) return false; // as almost always; then no root is needed
    const std::vector<std::uint32_t>& ring = hole_->ring;
    const double least = original_.least_cosine({ring[at(a)], ring[at(m)], ring[at(b)]});
    return product < least * glm::length(mean) * length;
}

bool Legality::allows_neighbours(const RingTriangle& triangle, const glm::dvec3* left, const glm::dvec3* right) const {
    if (minds_turns_) return true; // keeping to one normal, they keep to each other
    return (!left || !folds(triangle.normal, *left)) && (!right || !folds(triangle.normal, *right));
}

} // namespace meshbound
