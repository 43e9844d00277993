#include "errors/tracked/mapped_content.hpp"

#include <glm/geometric.hpp>

#include "util/indexing.hpp"

namespace meshbound {
namespace {

constexpr std::int8_t spoke_role = -1;

} // namespace

MappedContent::MappedContent(const Surface& surface)
    : edge_role_(surface.edge_count(), 0), vertex_role_(surface.vertex_count(), 0) {}

void MappedContent::enter(const Rows& rows, const Surface& surface, const MappedVertices& mapped_vertices,
                          const Hole& hole) {
    vertices_.clear();
    segments_found_ = false;
    prefetch_vertices(mapped_vertices, hole);
    if (hole.open) add_closing(rows, mapped_vertices, hole);
    else vertices_.push_back({hole.candidate, InnerVertex::Container::triangle});
    for (int sector = 0; sector < hole.sectors(); ++sector) {
        add_sector(mapped_vertices, hole, sector);
        if (surface.twin(hole.link_half_edges[to_index(sector)]) == no_index)
            add_link_edge(mapped_vertices, hole, sector);
    }
}

void MappedContent::prefetch_vertices(const MappedVertices& mapped_vertices, const Hole& hole) {
    prefetcher_.clear();
    for (const std::uint32_t slot : hole.slots) prefetcher_.add(mapped_vertices.in_triangle(slot));
    prefetcher_.follow([&](std::uint32_t vertex) {
        mapped_vertices.prefetch_coordinates(vertex);
        return mapped_vertices.next(vertex);
    });
}

void MappedContent::prefetch_crossings(const Crossings& crossings, const Hole& hole) {
    prefetcher_.clear();
    for (const std::uint32_t edge : hole.link_edges) prefetcher_.add(crossings.on(edge));
    for (const std::uint32_t edge : hole.spoke_edges) prefetcher_.add(crossings.on(edge));
    prefetcher_.follow([&](std::uint32_t crossing) { return crossings[crossing].sibling; });
}

/// The vertices mapped into one of the star's triangles, as laid out.
void MappedContent::add_sector(const MappedVertices& mapped_vertices, const Hole& hole, int sector) {
    const std::uint32_t link_edge = hole.link_half_edges[to_index(sector)];
    const auto corner = [](std::uint32_t h) { return static_cast<int>(h % 3); };
    const int first = corner(link_edge),
              second = corner(Surface::next(link_edge)); // the third is the candidate, at the origin
    const glm::dvec2 p = hole.layout[to_index(sector)], q = hole.layout[to_index(hole.after(sector))];
    for (std::uint32_t v = mapped_vertices.in_triangle(hole.slots[to_index(sector)]); v != no_index;
         v = mapped_vertices.next(v)) {
        const glm::dvec3 weight = mapped_vertices.barycentric(v);
        vertices_.push_back({v, InnerVertex::Container::triangle, -1, weight[first] * p + weight[second] * q});
    }
}

/// The candidate of an open hole, and the vertices mapped onto its two boundary edges, go to the closing edge, at
/// proportional lengths (§3.2.2, figure 3).
void MappedContent::add_closing(const Rows& rows, const MappedVertices& mapped_vertices, const Hole& hole) {
    const glm::dvec3 centre = rows.position(hole.candidate);
    const double before = glm::distance(rows.position(hole.ring.front()), centre);
    const double behind = glm::distance(rows.position(hole.ring.back()), centre);
    const double middle = before + behind > 0 ? before / (before + behind) : 0.5;
    const auto add = [&](std::uint32_t vertex, double share) {
        const glm::dvec2 layout = hole.layout.front() + share * (hole.layout.back() - hole.layout.front());
        vertices_.push_back({vertex, InnerVertex::Container::closing_edge, -1, layout, share});
    };
    add(hole.candidate, middle);
    for (const bool first : {true, false}) {
        const std::uint32_t edge = first ? hole.spoke_edges.front() : hole.spoke_edges.back();
        const std::uint32_t start = first ? hole.ring.front() : hole.candidate;
        const std::uint32_t end = first ? hole.candidate : hole.ring.back();
        for (std::uint32_t v = mapped_vertices.on_edge(edge); v != no_index; v = mapped_vertices.next(v)) {
            const double along = start < end ? mapped_vertices.share(v) : 1 - mapped_vertices.share(v);
            add(v, first ? along * middle : middle + along * (1 - middle));
        }
    }
}

void MappedContent::fix_closing_share(std::size_t inner, double share, const Hole& hole) {
    InnerVertex& vertex = vertices_[inner];
    vertex.share = share;
    vertex.layout = hole.layout.front() + share * (hole.layout.back() - hole.layout.front());
    vertex.share_is_fixed = true;
}

void MappedContent::add_link_edge(const MappedVertices& mapped_vertices, const Hole& hole, int link_edge) {
    // Vertices mapped onto a link edge stay where they are.
    const std::uint32_t lower_end = hole.ring[to_index(link_edge)],
                        upper_end = hole.ring[to_index(hole.after(link_edge))];
    const glm::dvec2 p = hole.layout[to_index(link_edge)], q = hole.layout[to_index(hole.after(link_edge))];
    for (std::uint32_t v = mapped_vertices.on_edge(hole.link_edges[to_index(link_edge)]); v != no_index;
         v = mapped_vertices.next(v)) {
        const double along = lower_end < upper_end ? mapped_vertices.share(v) : 1 - mapped_vertices.share(v);
        vertices_.push_back({v, InnerVertex::Container::link_edge, link_edge, p + along * (q - p)});
    }
}

void MappedContent::mark(const Hole& hole) {
    for (int link_edge = 0; link_edge < hole.sectors(); ++link_edge)
        edge_role_[hole.link_edges[to_index(link_edge)]] = static_cast<std::int8_t>(1 + link_edge);
    for (const std::uint32_t edge : hole.spoke_edges) edge_role_[edge] = spoke_role;
    for (int i = 0; i < hole.size(); ++i) vertex_role_[hole.ring[to_index(i)]] = 1 + i;
    for (std::size_t i = 0; i < vertices_.size(); ++i) vertex_role_[vertices_[i].vertex] = -1 - static_cast<int>(i);
}

void MappedContent::unmark(const Hole& hole) {
    for (const std::uint32_t edge : hole.link_edges) edge_role_[edge] = 0;
    for (const std::uint32_t edge : hole.spoke_edges) edge_role_[edge] = 0;
    for (const std::uint32_t vertex : hole.ring) vertex_role_[vertex] = 0;
    for (const InnerVertex& inner : vertices_) vertex_role_[inner.vertex] = 0;
}

SegmentEnd MappedContent::end_at_link_edge(const Crossings& crossings, std::uint32_t id) const {
    return {edge_role_[crossings[id].current] - 1, id};
}

/// Follows an original edge over its crossings with spokes, which vanish, to the next crossing with a link edge;
/// no_index at the end of the original edge.
std::uint32_t MappedContent::walk(const Crossings& crossings, std::uint32_t from, bool forward) const {
    std::uint32_t id = from;
    while (id != no_index) {
        const Crossing& crossing = crossings[id];
        if (edge_role_[crossing.current] != spoke_role) break;
        id = forward ? crossing.next : crossing.previous;
    }
    return id;
}

/// Segments that begin at this link edge, and those from a vertex to it.
void MappedContent::add_link_edge_segments(const OriginalEdges& edges, const Crossings& crossings, const Hole& hole,
                                           int link_edge) {
    const bool canonical =
        hole.ring[to_index(link_edge)] < hole.ring[to_index(hole.after(link_edge))]; // then the hole is on its left
    for (std::uint32_t id = crossings.on(hole.link_edges[to_index(link_edge)]); id != no_index;
         id = crossings[id].sibling) {
        const Crossing& crossing = crossings[id];
        const bool entering = crossing.rightward != canonical;
        if (entering) {
            const std::uint32_t end = walk(crossings, crossing.next, true);
            segments_.push_back(
                {crossing.original, end_at_link_edge(crossings, id),
                 end == no_index ? end_at_vertex(edges.upper(crossing.original)) : end_at_link_edge(crossings, end)});
        } else if (walk(crossings, crossing.previous, false) == no_index) {
            segments_.push_back(
                {crossing.original, end_at_vertex(edges.lower(crossing.original)), end_at_link_edge(crossings, id)});
        }
    }
}

/// Entire original edges from this inner vertex to another one or to the ring.
void MappedContent::add_vertex_segments(const OriginalEdges& edges, const Crossings& crossings, std::uint32_t vertex) {
    const SegmentEnd here = end_at_vertex(vertex);
    for (const auto& [edge, end] : edges.incident_to(vertex)) {
        const int role = vertex_role_[end];
        if (role == 0) continue; // leaves the hole across a link edge: found there
        const bool from_lower = vertex < end;
        if (!from_lower && role < 0) continue; // found from its lower end
        const std::uint32_t id = from_lower ? crossings.first(edge) : crossings.last(edge);
        if (walk(crossings, id, from_lower) != no_index) continue; // reaches a link edge: found there
        const SegmentEnd there{role};
        const bool crosses = id != no_index;
        segments_.push_back(from_lower ? EdgeSegment{edge, here, there, crosses}
                                       : EdgeSegment{edge, there, here, crosses});
    }
}

/// Entire original edges from ring to ring, each found at its first crossing with a spoke.
void MappedContent::add_spoke_segments(const OriginalEdges& edges, const Crossings& crossings,
                                       std::uint32_t spoke_edge) {
    for (std::uint32_t id = crossings.on(spoke_edge); id != no_index; id = crossings[id].sibling) {
        if (crossings[id].previous != no_index) continue;
        const std::uint32_t edge = crossings[id].original;
        if (vertex_role_[edges.lower(edge)] <= 0 || vertex_role_[edges.upper(edge)] <= 0) continue;
        if (walk(crossings, crossings[id].next, true) != no_index) continue; // reaches a link edge: found there
        segments_.push_back({edge, end_at_vertex(edges.lower(edge)), end_at_vertex(edges.upper(edge))});
    }
}

void MappedContent::find_segments(const OriginalEdges& edges, const Crossings& crossings, const Hole& hole) {
    if (segments_found_) return;
    segments_found_ = true;
    segments_.clear();
    mark(hole);
    prefetch_crossings(crossings, hole);
    for (int link_edge = 0; link_edge < hole.sectors(); ++link_edge)
        add_link_edge_segments(edges, crossings, hole, link_edge);
    for (const InnerVertex& inner : vertices_) edges.prefetch_incident(inner.vertex);
    for (const InnerVertex& inner : vertices_) add_vertex_segments(edges, crossings, inner.vertex);
    for (const std::uint32_t spoke : hole.spoke_edges) add_spoke_segments(edges, crossings, spoke);
    unmark(hole);
}

} // namespace meshbound
