#pragma once

#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include <glm/vec3.hpp>

namespace meshbound {

struct Hole;
struct NewTriangle;
struct Retriangulation;

/// No half-edge, no triangle, no vertex, no edge.
inline constexpr std::uint32_t no_index = std::numeric_limits<std::uint32_t>::max();

/// What a vertex is on the surface (§3.2, figure 1).
enum class VertexKind : std::uint8_t {
    absent,   ///< in no triangle, or removed
    interior, ///< its triangles form one closed fan
    boundary, ///< its triangles form one open fan
};

/// The current surface: who borders whom. A corner table: triangle t has the half-edges 3t, 3t + 1, 3t + 2; half-edge h
/// runs from `origin(h)` to `target(h)`, counter-clockwise, with the triangle on its left.
///
///     triangles {0,1,2}, {0,2,3}:  half-edges 0: 0→1, 1: 1→2, 2: 2→0, 3: 0→2, 4: 2→3, 5: 3→0;  twin(2) = 3
///
/// It consists of *sheets*, which are manifold whatever the input is: it is cut open along *curves*, the edges that do not have
/// exactly two half-edges of opposite direction in triangles of one region, and each fan of triangles around a vertex of the
/// input has a vertex of its own, a *copy* (an input without such edges and without bow-ties has one copy of each vertex).
/// Copies are numbered in the order of the input's vertices. The copies of one vertex, and of vertices on seams in one place
/// (see find_seams), form a *site*: they are removed together or not at all, so that sheets stay joined as they are.
///
/// Triangles with a repeated vertex are left out.
///
/// How it is cut open: sheets.cpp; what belongs together: sites.cpp; what a removal changes: surface.cpp.
class Surface {
public:
    Surface() = default;
    /// `regions`: a label a triangle, or none.
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
    /// Slots for triangles, the dead ones among them.
    std::size_t slot_count() const { return origin_.size() / 3; }
    bool alive(std::uint32_t triangle) const { return origin_[3 * std::size_t(triangle)] != no_index; }
    std::size_t edge_count() const { return edge_count_; }
    /// Edges that two triangles run along in the same direction, at the start.
    std::size_t discordant_edges() const { return discordant_edges_; }
    /// Whether triangles of the input are on the same three vertices (see OneSided).
    bool has_coincident_triangles() const { return has_coincident_; }
    /// Whether no edge is a boundary, and none is one of several sheets.
    bool is_closed() const;
    /// Vertices of the input on edges of three or more triangles or of two that disagree, and in bow-ties.
    std::size_t non_manifold_vertices() const { return non_manifold_vertices_; }

    /// The vertex of the input that a vertex is a copy of, and that vertex's first copy.
    std::uint32_t input(std::uint32_t vertex) const { return inputs_.empty() ? vertex : inputs_[vertex]; }
    std::uint32_t first_copy(std::uint32_t input) const { return first_copy_.empty() ? input : first_copy_[input]; }
    std::size_t input_count() const { return first_copy_.empty() ? kind_.size() : first_copy_.size(); }
    /// By vertex; empty where every vertex is its only copy.
    const std::vector<std::uint32_t>& inputs() const { return inputs_; }
    /// The label of a triangle; 0 where there are none. A new triangle has that of the star it fills.
    std::int32_t region(std::uint32_t slot) const { return regions_.empty() ? 0 : regions_[slot]; }
    bool has_regions() const { return !regions_.empty(); }

    /// The vertex that names a site: the lowest of its vertices.
    std::uint32_t site(std::uint32_t vertex) const { return sites_.empty() ? vertex : sites_[vertex]; }
    bool has_sites() const { return !sites_.empty(); }
    /// Calls `visit(vertex)` for every vertex of a site, whichever of them is given, in the order of the numbers.
    template <class Visit>
    void for_each_in_site(std::uint32_t vertex, const Visit& visit) const {
        if (sites_.empty()) return visit(vertex);
        for (std::uint32_t v = sites_[vertex]; v != no_index; v = next_in_site_[v]) visit(v);
    }
    /// Makes vertices those of one site, before anything is removed: each list of pairs is one call.
    void join_sites(const std::vector<std::pair<std::uint32_t, std::uint32_t>>& pairs);
    /// Whether a site may go: a vertex inside a sheet or on its boundary, or the vertices of a curve between the same two
    /// neighbours on every sheet. Not where curves meet or end, nor in bow-ties.
    bool is_free(std::uint32_t vertex) const;
    /// Whether a triangle of these three sites exists.
    bool triangle_exists(std::uint32_t a, std::uint32_t b, std::uint32_t c) const;

    /// Replaces the star of the hole's candidate by the new triangles; they take the slots of the first of the old ones,
    /// the diagonals (and the closing edge) take edges of the vanished spokes. The hole is brought up to date: `new_slots`
    /// and the edges of the retriangulation are filled.
    void retriangulate(const Hole& hole, Retriangulation& retriangulation);

    /// Takes away the marked vertices with their triangles; no triangle has both marked and unmarked ones. Returns how many
    /// triangles went.
    std::size_t drop(const std::vector<char>& vertices);

private:
    /// What lies behind a rim of a hole.
    struct Rim {
        std::uint32_t twin, edge;
    };
    void attach(std::uint32_t h, const Rim& rim);
    void take_out(const Hole& hole, Rim* rims);
    void put_in(const Hole& hole, const NewTriangle& triangle, const Rim* rims);
    void join(const NewTriangle& triangle, const NewTriangle* parent);
    void refresh_vertices(const NewTriangle& triangle);
    void pair_half_edges();
    void pair(std::uint32_t h, std::uint32_t g);
    /// The fan of a vertex of the input that begins with a half-edge, at the boundary where it is open.
    struct Fan {
        std::uint32_t input, start;
    };
    void cut_borders();
    /// Calls `visit(spoke)` along the fan that a half-edge begins.
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
    void split_vertices();
    std::uint32_t last_in_fan(std::uint32_t vertex) const;

    std::vector<std::uint32_t> origin_, twin_, edge_; // by half-edge
    std::vector<std::uint32_t> outgoing_;             // by vertex
    std::vector<VertexKind> kind_;                    // by vertex
    std::vector<std::int32_t> regions_;               // by slot; empty where there are none
    std::vector<std::uint32_t> inputs_, first_copy_;  // by vertex, by vertex of the input; empty: all are themselves
    std::vector<std::uint32_t> sites_, next_in_site_; // by vertex; empty: all sites are single vertices
    std::size_t edge_count_ = 0, discordant_edges_ = 0, non_manifold_vertices_ = 0;
    bool has_coincident_ = false;
};

} // namespace meshbound
