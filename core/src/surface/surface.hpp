#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include <glm/vec3.hpp>

#include "util/indexing.hpp"

namespace meshbound {

struct Hole;
struct NewTriangle;
struct Retriangulation;

/// What a vertex is on the surface (§3.2, figure 1).
enum class VertexKind : std::uint8_t {
    absent,   ///< in no triangle, or removed
    interior, ///< its triangles form one closed fan
    boundary, ///< its triangles form one open fan
};

/// The connectivity of the current surface, as half-edges (a corner table): triangle t has the half-edges 3t, 3t + 1,
/// 3t + 2; half-edge h runs from `origin(h)` to `target(h)`, counter-clockwise, with the triangle on its left.
///
///     triangles {0,1,2}, {0,2,3}:  half-edges 0: 0→1, 1: 1→2, 2: 2→0, 3: 0→2, 4: 2→3, 5: 3→0;  twin(2) = 3
///
/// It consists of *sheets*, which are manifold whatever the input is: it is cut open along *curves*, the edges that do
/// not have exactly two half-edges of opposite direction in triangles of one region, and each fan of triangles around
/// an input vertex has a vertex of its own (where there are no such edges and no bow-ties, one for each input vertex),
/// numbered in the order of the input vertices. The vertices of one input vertex, and those that coincide along a seam
/// (see find_seams), form a *coincidence class*: they are removed together or not at all, so that sheets stay joined as
/// they are. Its lowest vertex *represents* it.
///
/// Triangles with a repeated vertex are left out.
///
/// How it is cut open: sheets.cpp; coincidence classes: coincidence.cpp; what a removal changes: surface.cpp.
class Surface {
public:
    Surface() = default;
    /// `regions`: a label for each triangle, or none.
    Surface(const std::vector<glm::uvec3>& triangles, std::size_t vertices,
            const std::vector<std::int32_t>& regions = {});

    static std::uint32_t next(std::uint32_t h) { return h % 3 == 2 ? h - 2 : h + 1; }
    static std::uint32_t previous(std::uint32_t h) { return h % 3 == 0 ? h + 2 : h - 1; }
    static std::uint32_t triangle_of(std::uint32_t h) { return h / 3; }

    std::uint32_t origin(std::uint32_t h) const { return origin_[h]; }
    std::uint32_t target(std::uint32_t h) const { return origin_[next(h)]; }
    /// The half-edge of the same edge in the neighbouring triangle, or no_index.
    std::uint32_t twin(std::uint32_t h) const { return twin_[h]; }
    /// The undirected edge of a half-edge, 0 … edge_count() - 1; both halves share it.
    std::uint32_t edge(std::uint32_t h) const { return edge_[h]; }

    VertexKind kind(std::uint32_t vertex) const { return kind_[vertex]; }
    /// A half-edge that leaves the vertex; of a boundary vertex the one that runs along the boundary (it has no twin).
    std::uint32_t outgoing(std::uint32_t vertex) const { return outgoing_[vertex]; }
    /// The next half-edge that leaves the same vertex, counter-clockwise, or no_index at the end of an open fan.
    std::uint32_t next_spoke(std::uint32_t h) const { return twin_[previous(h)]; }

    /// Whether `holds(neighbour)` for all vertices around a vertex.
    template <class Holds>
    bool all_of_ring(std::uint32_t vertex, const Holds& holds) const {
        const std::uint32_t first = outgoing(vertex);
        std::uint32_t spoke = first;
        do {
            if (!holds(target(spoke))) return false;
            const std::uint32_t arriving = previous(spoke);
            spoke = twin(arriving);
            if (spoke == no_index) return holds(origin(arriving));
        } while (spoke != first);
        return true;
    }

    std::size_t vertex_count() const { return kind_.size(); }
    /// Slots for triangles, free ones among them.
    std::size_t slot_count() const { return origin_.size() / 3; }
    bool alive(std::uint32_t triangle) const { return origin_[3 * std::size_t(triangle)] != no_index; }
    std::size_t edge_count() const { return edge_count_; }
    /// Edges whose two half-edges run in the same direction, in the input.
    std::size_t inconsistent_edges() const { return inconsistent_edges_; }
    /// Whether triangles of the input are on the same three vertices (see OneSided).
    bool has_coincident_triangles() const { return has_coincident_; }
    /// Whether no edge is a boundary edge, neither of the input nor of a sheet.
    bool is_closed() const;
    /// Input vertices on edges of three or more triangles or of two with opposite orientations, and in bow-ties.
    std::size_t non_manifold_vertices() const { return non_manifold_vertices_; }

    /// The input vertex of a vertex, and the first of the vertices of an input vertex.
    std::uint32_t input(std::uint32_t vertex) const { return inputs_.empty() ? vertex : inputs_[vertex]; }
    std::uint32_t first_vertex_of(std::uint32_t input) const {
        return first_vertex_.empty() ? input : first_vertex_[input];
    }
    std::size_t input_count() const { return first_vertex_.empty() ? kind_.size() : first_vertex_.size(); }
    /// By vertex its input vertex; empty where each is its own.
    const std::vector<std::uint32_t>& inputs() const { return inputs_; }
    /// The label of a triangle; 0 where there are no labels. A new triangle has that of the star it replaces.
    std::int32_t region(std::uint32_t slot) const { return regions_.empty() ? 0 : regions_[slot]; }
    bool has_regions() const { return !regions_.empty(); }

    /// The lowest vertex of the coincidence class of a vertex.
    std::uint32_t representative(std::uint32_t vertex) const {
        return representatives_.empty() ? vertex : representatives_[vertex];
    }
    bool has_coincident_vertices() const { return !representatives_.empty(); }
    /// Calls `visit(vertex)` for every vertex of the coincidence class of a vertex, in rising order.
    template <class Visit>
    void for_each_coincident(std::uint32_t vertex, const Visit& visit) const {
        if (representatives_.empty()) return visit(vertex);
        for (std::uint32_t v = representatives_[vertex]; v != no_index; v = next_coincident_[v]) visit(v);
    }
    /// Merges the coincidence classes of pairs of vertices, before anything is removed.
    void join_coincident(const std::vector<std::pair<std::uint32_t, std::uint32_t>>& pairs);
    /// Whether the coincidence class of a vertex may be removed: a vertex inside a sheet or on its boundary, or the
    /// vertices of a curve between the same two neighbours on every sheet. Not where curves meet or end, nor in
    /// bow-ties.
    bool is_removable(std::uint32_t vertex) const;
    /// Whether a triangle of these three coincidence classes exists; they are given by their lowest vertices.
    bool triangle_exists(std::uint32_t a, std::uint32_t b, std::uint32_t c) const;

    /// Replaces the star of the hole's candidate by the new triangles. They reuse the slots of the first of the old
    /// ones; the diagonals (and the closing edge) reuse the edges of the spokes. Fills NewTriangle::slot and
    /// NewTriangle::edge.
    void retriangulate(const Hole& hole, Retriangulation& retriangulation);

    /// Removes the marked vertices with their triangles; no triangle has both marked and unmarked ones. Returns how
    /// many triangles were removed.
    std::size_t remove_marked(const std::vector<char>& vertices);

private:
    /// What lies on the other side of a link edge.
    struct OuterEdge {
        std::uint32_t twin, edge;
    };
    void attach(std::uint32_t h, const OuterEdge& outer_edge);
    void detach_star(const Hole& hole, OuterEdge* outer_edges);
    void insert_triangle(const Hole& hole, const NewTriangle& triangle, const OuterEdge* outer_edges);
    void connect_to_parent(const NewTriangle& triangle, const NewTriangle* parent);
    void refresh_vertices(const NewTriangle& triangle);
    void pair_half_edges();
    void pair(std::uint32_t h, std::uint32_t g);
    /// A fan of triangles around an input vertex: its first half-edge, at the boundary where the fan is open.
    struct Fan {
        std::uint32_t input, start;
    };
    void cut_region_borders();
    /// Calls `visit(spoke)` for the half-edges of the fan that begins with `start`.
    template <class Visit>
    void walk_fan(std::uint32_t start, const Visit& visit) const {
        std::uint32_t spoke = start;
        do {
            visit(spoke);
            spoke = next_spoke(spoke);
        } while (spoke != no_index && spoke != start);
    }
    std::uint32_t fan_length(std::uint32_t start) const;
    std::size_t classify();
    std::vector<Fan> find_fans() const;
    void separate_fans();
    std::uint32_t last_in_fan(std::uint32_t vertex) const;

    std::vector<std::uint32_t> origin_, twin_, edge_;  // by half-edge
    std::vector<std::uint32_t> outgoing_;              // by vertex
    std::vector<VertexKind> kind_;                     // by vertex
    std::vector<std::int32_t> regions_;                // by slot; empty where there are none
    std::vector<std::uint32_t> inputs_, first_vertex_; // by vertex, by input vertex; empty: all are themselves
    std::vector<std::uint32_t> representatives_, next_coincident_; // by vertex; empty: no vertices coincide
    std::size_t edge_count_ = 0, inconsistent_edges_ = 0, non_manifold_vertices_ = 0;
    bool has_coincident_ = false;
};

} // namespace meshbound
