#pragma once

#include <cstdint>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "util/chains_in_step.hpp"
#include "errors/tracked/crossings.hpp"
#include "surface/hole.hpp"
#include "errors/tracked/original_edges.hpp"
#include "errors/tracked/residents.hpp"
#include "metric/rows.hpp"

namespace meshbound {

/// An original vertex inside the hole or on its boundary edges, at a place of the laid-out star.
struct InnerVertex {
    enum class Host {
        triangle, ///< anywhere in the hole: it is located in one of the new triangles
        closing,  ///< on the closing edge of an open hole
        rim,      ///< on a rim that is a boundary edge: it stays where it is
    };
    std::uint32_t vertex = no_index;
    Host host = Host::triangle;
    int rim = -1;         ///< of Host::rim
    glm::dvec2 place{0};  ///< in the plane
    double share = 0;     ///< of Host::closing: along the closing edge, from ring position 0
    bool settled = false; ///< of Host::closing: the share was agreed on with other sheets
};

/// The end of a piece: a crossing on a rim, or a ring vertex or an inner vertex where the original edge ends, too. Small, since
/// a hole may have thousands of them.
struct PieceEnd {
    int where = 0; ///< the rim; of a vertex 1 + its ring position, or -(1 + index of the inner vertex)
    std::uint32_t crossing = no_index; ///< on the rim; no_index: a vertex

    bool is_crossing() const { return crossing != no_index; }
    bool is_inner() const { return where < 0; }
    int rim() const { return where; }
    int inner() const { return -1 - where; }
    /// Of a ring vertex its position, else -1.
    int ring() const { return is_crossing() || is_inner() ? -1 : where - 1; }
};

/// A part of an original edge inside the hole, between places that remain when the spokes vanish.
struct Piece {
    std::uint32_t original = no_index;
    PieceEnd start, end; ///< s rising
    bool crosses = true; ///< any current edge, spokes included; most pieces of a large hole do not
};

/// What the map has in a hole: every original vertex and every piece of an original edge that lies in it (design: tracked).
class HoleContent {
public:
    explicit HoleContent(const Surface& surface);

    /// Finds the inner vertices.
    void enter(const Rows& rows, const Surface& surface, const Residents& residents, const Hole& hole);
    /// Finds the pieces, unless it has found those of this hole; enter comes first.
    void find_pieces(const OriginalEdges& edges, const Crossings& crossings, const Hole& hole);

    /// Settles an inner vertex of the closing edge at a share of it, for good.
    void settle_on_closing(std::size_t inner, double share, const Hole& hole);

    const std::vector<InnerVertex>& vertices() const { return vertices_; }
    const std::vector<Piece>& pieces() const { return pieces_; }

private:
    void fetch_residents(const Residents& residents, const Hole& hole);
    void fetch_crossings(const Crossings& crossings, const Hole& hole);
    void add_sector(const Residents& residents, const Hole& hole, int sector);
    void add_closing(const Rows& rows, const Residents& residents, const Hole& hole);
    void add_rim(const Residents& residents, const Hole& hole, int rim);
    void mark(const Hole& hole);
    void unmark(const Hole& hole);
    PieceEnd end_at_vertex(std::uint32_t vertex) const { return {position_[vertex]}; }
    PieceEnd end_at_rim(const Crossings& crossings, std::uint32_t id) const;
    std::uint32_t walk(const Crossings& crossings, std::uint32_t from, bool forward) const;
    void add_rim_pieces(const OriginalEdges& edges, const Crossings& crossings, const Hole& hole, int rim);
    void add_vertex_pieces(const OriginalEdges& edges, const Crossings& crossings, std::uint32_t vertex);
    void add_spoke_pieces(const OriginalEdges& edges, const Crossings& crossings, std::uint32_t spoke_edge);

    std::vector<InnerVertex> vertices_;
    std::vector<Piece> pieces_;
    bool pieces_found_ = false;
    ChainsInStep chains_;
    std::vector<std::int8_t> role_; // by edge: 0 elsewhere, 1 + rim (largest_ring is small), or -1 of a spoke
    std::vector<int> position_;     // by vertex: 0 elsewhere, else as in PieceEnd::where
};

} // namespace meshbound
