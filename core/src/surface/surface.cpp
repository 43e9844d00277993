#include "surface/surface.hpp"

#include <algorithm>
#include <array>

#include "mesh/half_edges_by_edge.hpp"
#include "mesh/repeats_vertex.hpp"
#include "surface/hole.hpp"
#include "util/indexing.hpp"

namespace meshbound {

Surface::Surface(const std::vector<glm::uvec3>& triangles, std::size_t vertices,
                 const std::vector<std::int32_t>& regions)
    : outgoing_(vertices, no_index), kind_(vertices, VertexKind::absent) {
    origin_.reserve(3 * triangles.size());
    for (std::size_t t = 0; t < triangles.size(); ++t) {
        const glm::uvec3& triangle = triangles[t];
        if (repeats_vertex(triangle)) continue;
        for (int corner = 0; corner < 3; ++corner) origin_.push_back(triangle[corner]);
        if (!regions.empty()) regions_.push_back(regions[t]);
    }
    pair_half_edges();
    std::size_t vertices_to_separate = non_manifold_vertices_ = classify();
    if (!regions_.empty()) {
        cut_region_borders();
        vertices_to_separate = classify();
    }
    if (vertices_to_separate > 0) separate_fans();
}

void Surface::pair_half_edges() {
    twin_.assign(origin_.size(), no_index);
    edge_.assign(origin_.size(), no_index);
    CoincidentTriangleSearch coincidence(origin_);
    HalfEdgesByEdge(origin_, kind_.size()).for_each_edge([&](const std::uint32_t* run, std::size_t count) {
        has_coincident_ = has_coincident_ || coincidence.finds(run, count);
        if (count == 2 && origin(run[0]) != origin(run[1])) {
            pair(run[0], run[1]);
            return;
        }
        if (count == 2) ++inconsistent_edges_;
        for (std::size_t i = 0; i < count; ++i) edge_[run[i]] = static_cast<std::uint32_t>(edge_count_++);
    });
}

void Surface::pair(std::uint32_t h, std::uint32_t g) {
    twin_[h] = g;
    twin_[g] = h;
    edge_[h] = edge_[g] = static_cast<std::uint32_t>(edge_count_++);
}

bool Surface::is_closed() const { return std::find(kind_.begin(), kind_.end(), VertexKind::boundary) == kind_.end(); }

std::size_t Surface::remove_marked(const std::vector<char>& vertices) {
    std::size_t triangles = 0;
    for (std::size_t slot = 0; slot < slot_count(); ++slot) {
        if (!vertices[origin_[3 * slot]]) continue;
        origin_[3 * slot] = no_index;
        ++triangles;
    }
    for (std::size_t vertex = 0; vertex < vertices.size(); ++vertex) {
        if (!vertices[vertex]) continue;
        kind_[vertex] = VertexKind::absent;
        outgoing_[vertex] = no_index;
    }
    return triangles;
}

void Surface::attach(std::uint32_t h, const OuterEdge& outer_edge) {
    twin_[h] = outer_edge.twin;
    edge_[h] = outer_edge.edge;
    if (outer_edge.twin != no_index) twin_[outer_edge.twin] = h;
}

/// Removes the star, and writes down what lies across its link edges.
void Surface::detach_star(const Hole& hole, OuterEdge* outer_edges) {
    for (const std::uint32_t h : hole.link_half_edges) *outer_edges++ = {twin_[h], edge_[h]};
    for (const std::uint32_t slot : hole.slots) origin_[3 * std::size_t(slot)] = no_index;
    kind_[hole.candidate] = VertexKind::absent;
    outgoing_[hole.candidate] = no_index;
}

/// Writes a new triangle into its slot, and connects it across the link edges that it has.
void Surface::insert_triangle(const Hole& hole, const NewTriangle& triangle, const OuterEdge* outer_edges) {
    const std::uint32_t h = 3 * triangle.slot; // h: a → m, h + 1: m → b, h + 2: b → a
    origin_[h] = hole.ring[to_index(triangle.a)];
    origin_[h + 1] = hole.ring[to_index(triangle.m)];
    origin_[h + 2] = hole.ring[to_index(triangle.b)];
    if (triangle.left < 0) attach(h, outer_edges[triangle.a]);
    if (triangle.right < 0) attach(h + 1, outer_edges[triangle.m]);
    if (triangle.parent < 0 && !hole.open) attach(h + 2, outer_edges[triangle.b]);
}

/// Sets the edge of (a, b) of a new triangle, the diagonal to its parent or the closing edge, and connects it to the
/// parent.
void Surface::connect_to_parent(const NewTriangle& triangle, const NewTriangle* parent) {
    const std::uint32_t h = 3 * triangle.slot + 2; // b → a
    edge_[h] = triangle.edge;
    twin_[h] = no_index;
    if (!parent) return;
    const std::uint32_t g = 3 * parent->slot + (parent->a == triangle.a ? 0 : 1);
    twin_[h] = g;
    twin_[g] = h;
    edge_[g] = triangle.edge;
}

/// Updates the outgoing half-edges of the corners of a new triangle, once all of them are connected.
void Surface::refresh_vertices(const NewTriangle& triangle) {
    for (std::uint32_t h = 3 * triangle.slot; h < 3 * triangle.slot + 3; ++h) {
        const std::uint32_t vertex = origin(h);
        if (kind_[vertex] == VertexKind::interior || twin_[h] == no_index) outgoing_[vertex] = h;
    }
}

void Surface::retriangulate(const Hole& hole, Retriangulation& retriangulation) {
    std::array<OuterEdge, largest_ring> outer_edges; // not on the heap, whose lock threads would contend for
    detach_star(hole, outer_edges.data());
    std::vector<NewTriangle>& fresh = retriangulation.triangles;
    std::size_t spare_edge = 0;
    for (std::size_t n = 0; n < fresh.size(); ++n) {
        NewTriangle& triangle = fresh[n];
        triangle.slot = hole.slots[n];
        insert_triangle(hole, triangle, outer_edges.data());
        if (triangle.parent < 0 && !hole.open) {
            triangle.edge = edge_[3 * triangle.slot + 2];
            continue;
        }
        triangle.edge = hole.spoke_edges[spare_edge++];
        connect_to_parent(triangle, triangle.parent < 0 ? nullptr : &fresh[static_cast<std::size_t>(triangle.parent)]);
    }
    for (const NewTriangle& triangle : fresh) refresh_vertices(triangle);
}

} // namespace meshbound
