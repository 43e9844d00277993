#include "errors/tracked/hole_content.hpp"

#include <glm/geometric.hpp>

#include "util/indexing.hpp"

namespace meshbound {
namespace {

constexpr std::int8_t spoke_role = -1;

} // namespace

HoleContent::HoleContent(const Surface& surface)
    : role_(surface.edge_count(), 0), position_(surface.vertex_count(), 0) {}

void HoleContent::enter(const Rows& rows, const Surface& surface, const Residents& residents, const Hole& hole) {
    vertices_.clear();
    pieces_found_ = false;
    fetch_residents(residents, hole);
    if (hole.open) add_closing(rows, residents, hole);
    else vertices_.push_back({hole.candidate, InnerVertex::Host::triangle});
    for (int sector = 0; sector < hole.sectors(); ++sector) {
        add_sector(residents, hole, sector);
        if (surface.twin(hole.rims[at(sector)]) == no_index) add_rim(residents, hole, sector);
    }
}

void HoleContent::fetch_residents(const Residents& residents, const Hole& hole) {
    chains_.clear();
    for (const std::uint32_t slot : hole.slots) chains_.add(residents.in_triangle(slot));
    chains_.walk([&](std::uint32_t vertex) {
        residents.fetch_place(vertex);
        return residents.next(vertex);
    });
}

void HoleContent::fetch_crossings(const Crossings& crossings, const Hole& hole) {
    chains_.clear();
    for (const std::uint32_t edge : hole.rim_edges) chains_.add(crossings.on(edge));
    for (const std::uint32_t edge : hole.spoke_edges) chains_.add(crossings.on(edge));
    chains_.walk([&](std::uint32_t crossing) { return crossings[crossing].sibling; });
}

/// The residents of one of the star's triangles, at their places in the plane.
void HoleContent::add_sector(const Residents& residents, const Hole& hole, int sector) {
    const std::uint32_t rim = hole.rims[at(sector)];
    const auto corner = [](std::uint32_t h) { return static_cast<int>(h % 3); };
    const int first = corner(rim), second = corner(Surface::next(rim)); // the third is the candidate, at the origin
    const glm::dvec2 p = hole.places[at(sector)], q = hole.places[at(hole.after(sector))];
    for (std::uint32_t v = residents.in_triangle(hole.slots[at(sector)]); v != no_index; v = residents.next(v)) {
        const glm::dvec3 weight = residents.barycentric(v);
        vertices_.push_back({v, InnerVertex::Host::triangle, -1, weight[first] * p + weight[second] * q});
    }
}

/// The candidate of an open hole and the residents of its two boundary edges go to the closing edge, at proportional lengths
/// (§3.2.2, figure 3).
void HoleContent::add_closing(const Rows& rows, const Residents& residents, const Hole& hole) {
    const glm::dvec3 centre = rows.position(hole.candidate);
    const double before = glm::distance(rows.position(hole.ring.front()), centre);
    const double behind = glm::distance(rows.position(hole.ring.back()), centre);
    const double middle = before + behind > 0 ? before / (before + behind) : 0.5;
    const auto add = [&](std::uint32_t vertex, double share) {
        const glm::dvec2 place = hole.places.front() + share * (hole.places.back() - hole.places.front());
        vertices_.push_back({vertex, InnerVertex::Host::closing, -1, place, share});
    };
    add(hole.candidate, middle);
    for (const bool first : {true, false}) {
        const std::uint32_t edge = first ? hole.spoke_edges.front() : hole.spoke_edges.back();
        const std::uint32_t start = first ? hole.ring.front() : hole.candidate;
        const std::uint32_t end = first ? hole.candidate : hole.ring.back();
        for (std::uint32_t v = residents.on_edge(edge); v != no_index; v = residents.next(v)) {
            const double along = start < end ? residents.share(v) : 1 - residents.share(v);
            add(v, first ? along * middle : middle + along * (1 - middle));
        }
    }
}

void HoleContent::settle_on_closing(std::size_t inner, double share, const Hole& hole) {
    InnerVertex& vertex = vertices_[inner];
    vertex.share = share;
    vertex.place = hole.places.front() + share * (hole.places.back() - hole.places.front());
    vertex.settled = true;
}

void HoleContent::add_rim(const Residents& residents, const Hole& hole, int rim) {
    // The rim's edge lies across the sector's triangle from the candidate; its residents stay where they are.
    const std::uint32_t lower_end = hole.ring[at(rim)], upper_end = hole.ring[at(hole.after(rim))];
    const glm::dvec2 p = hole.places[at(rim)], q = hole.places[at(hole.after(rim))];
    for (std::uint32_t v = residents.on_edge(hole.rim_edges[at(rim)]); v != no_index; v = residents.next(v)) {
        const double along = lower_end < upper_end ? residents.share(v) : 1 - residents.share(v);
        vertices_.push_back({v, InnerVertex::Host::rim, rim, p + along * (q - p)});
    }
}

void HoleContent::mark(const Hole& hole) {
    for (int rim = 0; rim < hole.sectors(); ++rim) role_[hole.rim_edges[at(rim)]] = static_cast<std::int8_t>(1 + rim);
    for (const std::uint32_t edge : hole.spoke_edges) role_[edge] = spoke_role;
    for (int i = 0; i < hole.size(); ++i) position_[hole.ring[at(i)]] = 1 + i;
    for (std::size_t i = 0; i < vertices_.size(); ++i) position_[vertices_[i].vertex] = -1 - static_cast<int>(i);
}

void HoleContent::unmark(const Hole& hole) {
    for (const std::uint32_t edge : hole.rim_edges) role_[edge] = 0;
    for (const std::uint32_t edge : hole.spoke_edges) role_[edge] = 0;
    for (const std::uint32_t vertex : hole.ring) position_[vertex] = 0;
    for (const InnerVertex& inner : vertices_) position_[inner.vertex] = 0;
}

PieceEnd HoleContent::end_at_rim(const Crossings& crossings, std::uint32_t id) const {
    return {role_[crossings[id].current] - 1, id};
}

/// Along an original edge over the crossings with spokes, which vanish: to the next crossing with a rim, or to no_index at
/// the end of the original edge.
std::uint32_t HoleContent::walk(const Crossings& crossings, std::uint32_t from, bool forward) const {
    std::uint32_t id = from;
    while (id != no_index) {
        const Crossing& crossing = crossings[id];
        if (role_[crossing.current] != spoke_role) break;
        id = forward ? crossing.next : crossing.previous;
    }
    return id;
}

/// Pieces that begin at this rim, and those that end at it having begun at a vertex.
void HoleContent::add_rim_pieces(const OriginalEdges& edges, const Crossings& crossings, const Hole& hole, int rim) {
    const bool canonical =
        hole.ring[at(rim)] < hole.ring[at(hole.after(rim))]; // the hole is on the left of a canonical rim
    for (std::uint32_t id = crossings.on(hole.rim_edges[at(rim)]); id != no_index; id = crossings[id].sibling) {
        const Crossing& crossing = crossings[id];
        const bool entering = crossing.rightward != canonical;
        if (entering) {
            const std::uint32_t end = walk(crossings, crossing.next, true);
            pieces_.push_back(
                {crossing.original, end_at_rim(crossings, id),
                 end == no_index ? end_at_vertex(edges.upper(crossing.original)) : end_at_rim(crossings, end)});
        } else if (walk(crossings, crossing.previous, false) == no_index) {
            pieces_.push_back(
                {crossing.original, end_at_vertex(edges.lower(crossing.original)), end_at_rim(crossings, id)});
        }
    }
}

/// Whole original edges from this inner vertex to another inner vertex or to the ring.
void HoleContent::add_vertex_pieces(const OriginalEdges& edges, const Crossings& crossings, std::uint32_t vertex) {
    const PieceEnd here = end_at_vertex(vertex);
    for (const auto& [edge, end] : edges.at(vertex)) {
        const int position = position_[end];
        if (position == 0) continue; // leaves the hole by a rim: found there
        const bool from_lower = vertex < end;
        if (!from_lower && position < 0) continue; // found from its lower end
        const std::uint32_t id = from_lower ? crossings.first(edge) : crossings.last(edge);
        if (walk(crossings, id, from_lower) != no_index) continue; // reaches a rim: found there
        const PieceEnd there{position};
        const bool crosses = id != no_index;
        pieces_.push_back(from_lower ? Piece{edge, here, there, crosses} : Piece{edge, there, here, crosses});
    }
}

/// Whole original edges from ring to ring, each at its first crossing with a spoke.
void HoleContent::add_spoke_pieces(const OriginalEdges& edges, const Crossings& crossings, std::uint32_t spoke_edge) {
    for (std::uint32_t id = crossings.on(spoke_edge); id != no_index; id = crossings[id].sibling) {
        if (crossings[id].previous != no_index) continue;
        const std::uint32_t edge = crossings[id].original;
        if (position_[edges.lower(edge)] <= 0 || position_[edges.upper(edge)] <= 0) continue;
        if (walk(crossings, crossings[id].next, true) != no_index) continue; // reaches a rim: found there
        pieces_.push_back({edge, end_at_vertex(edges.lower(edge)), end_at_vertex(edges.upper(edge))});
    }
}

void HoleContent::find_pieces(const OriginalEdges& edges, const Crossings& crossings, const Hole& hole) {
    if (pieces_found_) return;
    pieces_found_ = true;
    pieces_.clear();
    mark(hole);
    fetch_crossings(crossings, hole);
    for (int rim = 0; rim < hole.sectors(); ++rim) add_rim_pieces(edges, crossings, hole, rim);
    for (const InnerVertex& inner : vertices_) edges.fetch_spokes(inner.vertex);
    for (const InnerVertex& inner : vertices_) add_vertex_pieces(edges, crossings, inner.vertex);
    for (const std::uint32_t spoke : hole.spoke_edges) add_spoke_pieces(edges, crossings, spoke);
    unmark(hole);
}

} // namespace meshbound
