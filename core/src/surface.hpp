#pragma once

#include <cstdint>
#include <limits>
#include <unordered_set>
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
    fixed,    ///< anything else: non-manifold edges, bow-ties; never a candidate
};

/// The current surface: who borders whom. A corner table: triangle t has the half-edges 3t, 3t + 1, 3t + 2; half-edge h
/// runs from `origin(h)` to `target(h)`, counter-clockwise, with the triangle on its left.
///
///     triangles {0,1,2}, {0,2,3}:  half-edges 0: 0→1, 1: 1→2, 2: 2→0, 3: 0→2, 4: 2→3, 5: 3→0;  twin(2) = 3
///
/// Edges that do not have exactly two half-edges of opposite direction have no twins: boundary where there is one half-edge,
/// non-manifold else, and then their vertices are fixed. Triangles with a repeated vertex are left out.
class Surface {
public:
    Surface() = default;
    Surface(const std::vector<glm::uvec3>& triangles, std::size_t vertices);

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

    std::size_t vertex_count() const { return kind_.size(); }
    /// Slots for triangles, the dead ones among them.
    std::size_t slot_count() const { return origin_.size() / 3; }
    bool alive(std::uint32_t triangle) const { return origin_[3 * std::size_t(triangle)] != no_index; }
    std::size_t edge_count() const { return edge_count_; }
    /// Edges that two triangles run along in the same direction, at the start.
    std::size_t discordant_edges() const { return discordant_edges_; }
    std::size_t count(VertexKind kind) const;

    /// Whether two fixed vertices are joined by an edge (the fans of fixed vertices cannot be walked).
    bool fixed_edge_exists(std::uint32_t a, std::uint32_t b) const;

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
    std::vector<Rim> take_out(const Hole& hole);
    void put_in(const Hole& hole, const NewTriangle& triangle, const std::vector<Rim>& rims);
    void join(const NewTriangle& triangle, const NewTriangle* parent);
    void refresh_vertices(const NewTriangle& triangle);
    void pair_half_edges();
    void pair(std::uint32_t h, std::uint32_t g);
    void classify();
    void remember_fixed_edges();
    std::uint32_t fan_length(std::uint32_t start) const;

    std::vector<std::uint32_t> origin_, twin_, edge_; // by half-edge
    std::vector<std::uint32_t> outgoing_;             // by vertex
    std::vector<VertexKind> kind_;                    // by vertex
    std::unordered_set<std::uint64_t> fixed_edges_;   // between fixed vertices; such edges never vanish
    std::size_t edge_count_ = 0, discordant_edges_ = 0;
};

} // namespace meshbound
