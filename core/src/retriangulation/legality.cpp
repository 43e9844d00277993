#include "retriangulation/legality.hpp"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "geometry/plane.hpp"
#include "retriangulation/layout.hpp"
#include "util/indexing.hpp"

namespace meshbound {
namespace {

/// The least cosine between the normals of new triangles and the hole's (about 84°), where that is limited.
constexpr double least_deviation_cosine = 0.1;

/// The least cosine between the normals across an edge (a dihedral angle of 60°), or the least that the star had
/// before, whichever is less (a crease may move); beyond, the surface folds onto itself. Negative.
constexpr double sharpest_bend_cosine = -0.5;

/// A laid-out triangle with an area below this fraction of the hole's squared size is degenerate.
constexpr double least_area = 1e-9;

/// The cosine between two vectors where it is negative, else 0 (as almost always; then no root is needed). A zero
/// vector, of a triangle without area, gives none.
double negative_cosine(const glm::dvec3& a, const glm::dvec3& b) {
    const double product = glm::dot(a, b);
    return product < 0 ? product / std::sqrt(glm::dot(a, a) * glm::dot(b, b)) : 0;
}

} // namespace

bool Legality::enter(const Surface& surface, const Rows& rows, const Hole& hole) {
    hole_ = &hole;
    if (!topology_allows_removal(surface, hole)) return false;
    surface_ = &surface;
    edge_existence_.assign(to_index(hole.size() * hole.size()), EdgeExistence::unknown);
    if (surface.has_coincident_vertices()) find_existing_edges(surface, hole);
    if (touches_own_class(surface, hole)) return false;
    if (hole.open && edge_exists(0, hole.size() - 1))
        return false; // the closing edge exists: the boundary loop has three edges
    if (limits_normal_deviation_) limit_deviation_from(star_normal(hole));
    look_up_original_normals(hole);
    find_neighbours(surface, rows, hole);
    double squared_size = 0;
    for (const glm::dvec2& point : hole.layout) squared_size = std::max(squared_size, glm::dot(point, point));
    least_area_ = least_area * squared_size;
    return true;
}

bool Legality::topology_allows_removal(const Surface& surface, const Hole& hole) const {
    if (hole.size() < 3) return false;
    if (hole.size() > 3 || hole.open) return true;
    for (int link_edge = 0; link_edge < 3; ++link_edge) { // a triangle beyond would close a tetrahedron
        const std::uint32_t across = surface.twin(hole.link_half_edges[to_index(link_edge)]);
        if (across != no_index && surface.target(Surface::next(across)) == hole.ring[to_index((link_edge + 2) % 3)])
            return false;
    }
    return !surface.has_coincident_vertices() || !surface.triangle_exists(hole.ring[0], hole.ring[1], hole.ring[2]);
}

/// Finds the ring vertices that are joined by an edge outside the star: by the one-rings of all vertices of their
/// coincidence classes, since sheets must not come to touch where they do not.
void Legality::find_existing_edges(const Surface& surface, const Hole& hole) {
    std::fill(edge_existence_.begin(), edge_existence_.end(), EdgeExistence::no);
    ring_filter_ = 0;
    ring_representatives_.clear();
    for (const std::uint32_t vertex : hole.ring) ring_representatives_.push_back(surface.representative(vertex));
    for (const std::uint32_t representative : ring_representatives_)
        ring_filter_ |= std::uint64_t{1} << (representative % 64);
    for (int i = 0; i < hole.size(); ++i) {
        const auto mark_neighbour = [&](std::uint32_t neighbour) {
            mark_edges_to(surface.representative(neighbour), i);
            return true;
        };
        surface.for_each_coincident(hole.ring[to_index(i)],
                                    [&](std::uint32_t vertex) { surface.all_of_ring(vertex, mark_neighbour); });
        mark_edges_to(ring_representatives_[to_index(i)], i); // no edge may join two vertices of one class
    }
}

/// Of ring indices that are not adjacent on the ring.
bool Legality::edge_exists(int i, int j) {
    EdgeExistence& existence = edge_existence_[to_index(i * hole_->size() + j)];
    if (existence == EdgeExistence::unknown) {
        const std::uint32_t end = hole_->ring[to_index(j)];
        const auto is_other = [&](std::uint32_t neighbour) { return neighbour != end; };
        existence = surface_->all_of_ring(hole_->ring[to_index(i)], is_other) ? EdgeExistence::no : EdgeExistence::yes;
    }
    return existence == EdgeExistence::yes;
}

bool Legality::allows_diagonals(const Retriangulation& retriangulation) {
    bool all = true;
    for (const NewTriangle& triangle : retriangulation.triangles)
        if (triangle.parent >= 0 && edge_exists(triangle.a, triangle.b)) all = false;
    return all;
}

/// Marks the edges from ring index i to all ring indices of a coincidence class.
void Legality::mark_edges_to(std::uint32_t representative, int i) {
    if (!(ring_filter_ >> (representative % 64) & 1)) return;
    for (int j = 0; j < hole_->size(); ++j)
        if (ring_representatives_[to_index(j)] == representative) mark_existing_edge(i, j);
}

/// Whether an edge joins two vertices of the candidate's coincidence class: their stars overlap, and cannot be removed
/// at once.
bool Legality::touches_own_class(const Surface& surface, const Hole& hole) const {
    return surface.has_coincident_vertices() &&
           std::find(ring_representatives_.begin(), ring_representatives_.end(),
                     surface.representative(hole.candidate)) != ring_representatives_.end();
}

void Legality::mark_existing_edge(int i, int j) {
    edge_existence_[to_index(i * hole_->size() + j)] = edge_existence_[to_index(j * hole_->size() + i)] =
        EdgeExistence::yes;
}

void Legality::limit_deviation_from(const glm::dvec3& normal) {
    const double length = glm::length(normal);
    normal_ = length > 0 ? normal / length : normal;
    least_cosine_ = length > 0 ? least_deviation_cosine : 0; // without a normal there is no deviation
}

void Legality::look_up_original_normals(const Hole& hole) {
    original_normals_.clear();
    for (const std::uint32_t vertex : hole.ring) original_normals_.push_back(original_.normal(vertex));
}

void Legality::find_neighbours(const Surface& surface, const Rows& rows, const Hole& hole) {
    neighbours_.assign(to_index(hole.sectors()), glm::dvec3(0));
    for (int i = 0; i < hole.sectors(); ++i) {
        const std::uint32_t twin = surface.twin(hole.link_half_edges[to_index(i)]);
        if (twin == no_index) continue;
        const glm::dvec3 &p = hole.positions[to_index(i)],
                         &q = hole.positions[to_index(hole.after(i))]; // the twin runs from q to p
        const glm::dvec3 tip = rows.position(surface.target(Surface::next(twin)));
        neighbours_[to_index(i)] = glm::cross(p - q, tip - q);
    }
}

/// The least cosine between the normals across the star's spokes and link edges before the removal; 0 where all are
/// positive.
double Legality::sharpest_bend() const {
    const Hole& hole = *hole_;
    const auto sector = [&](int i) {
        return glm::cross(hole.spokes[to_index(i)], hole.spokes[to_index(hole.after(i))]);
    };
    double least = 0;
    glm::dvec3 before = hole.open ? glm::dvec3(0) : sector(hole.sectors() - 1);
    for (int i = 0; i < hole.sectors(); ++i) {
        const glm::dvec3 here = sector(i);
        least = std::min({least, negative_cosine(before, here), negative_cosine(here, neighbours_[to_index(i)])});
        before = here;
    }
    return least;
}

/// The candidate of an open hole goes to the closing edge, so every diagonal must leave it on that side.
bool Legality::leaves_candidate(int i, int j) const {
    return orientation(hole_->layout[to_index(i)], hole_->layout[to_index(j)], glm::dvec2(0)) >= 0;
}

/// Whether the surface folds at an edge between two triangles, given by their normals.
bool Legality::folds(const glm::dvec3& p, const glm::dvec3& q) const {
    const double cosine = negative_cosine(p, q); // few are so small that sharpest_bend is needed
    return cosine < sharpest_bend_cosine && cosine < sharpest_bend();
}

bool Legality::folds_onto_neighbour(const RingTriangle& triangle, int link_edge) const {
    if (link_edge >= hole_->sectors()) return false; // the closing edge of an open hole
    return folds(neighbours_[to_index(link_edge)], triangle.normal);
}

bool Legality::allows_triangle(const RingTriangle& triangle) const {
    const auto& [a, m, b, u, v, w, normal, length] = triangle;
    if (limits_normal_deviation_ && glm::dot(normal, normal_) < least_cosine_ * length) return false;
    if (m == a + 1 && folds_onto_neighbour(triangle, a)) return false;
    if (b == m + 1 && folds_onto_neighbour(triangle, m)) return false;
    if (a == 0 && b == hole_->size() - 1 && folds_onto_neighbour(triangle, b)) return false;
    return !deviates_from_original(triangle);
}

/// By more than a right angle, and by more than any triangle of the original at its corners.
bool Legality::deviates_from_original(const RingTriangle& triangle) const {
    const auto& [a, m, b, u, v, w, normal, length] = triangle;
    const glm::dvec3 mean =
        original_normals_[to_index(a)] + original_normals_[to_index(m)] + original_normals_[to_index(b)];
    const double product = glm::dot(mean, normal);
    if (!(product < 0)) return false; // as almost always; then no root is needed
    const std::vector<std::uint32_t>& ring = hole_->ring;
    const double least = original_.least_cosine({ring[to_index(a)], ring[to_index(m)], ring[to_index(b)]});
    return product < least * glm::length(mean) * length;
}

bool Legality::allows_neighbours(const RingTriangle& triangle, const glm::dvec3* left, const glm::dvec3* right) const {
    if (limits_normal_deviation_) return true; // all of them are near one normal, so near each other
    return (!left || !folds(triangle.normal, *left)) && (!right || !folds(triangle.normal, *right));
}

} // namespace meshbound
