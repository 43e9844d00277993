#pragma once

#include <cstdint>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "crossings.hpp"
#include "hole.hpp"
#include "original_edges.hpp"
#include "residents.hpp"
#include "rows.hpp"

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

/// The end of a piece: a ring vertex, a crossing on a rim, or an inner vertex.
struct PieceEnd {
    int ring = -1;                     ///< ring position, or -1
    int rim = -1;                      ///< rim, or -1
    int inner = -1;                    ///< index of the inner vertex, or -1
    std::uint32_t crossing = no_index; ///< the crossing on the rim; no_index: an end of the original edge
    double s = 0;                      ///< along the original edge
};

/// A part of an original edge inside the hole, between places that remain when the spokes vanish.
struct Piece {
    std::uint32_t original = no_index;
    PieceEnd start, end; // s rising
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
    void add_sector(const Residents& residents, const Hole& hole, int sector);
    void add_closing(const Rows& rows, const Residents& residents, const Hole& hole);
    void add_rim(const Residents& residents, const Hole& hole, int rim);
    void mark(const Hole& hole);
    void unmark(const Hole& hole);
    PieceEnd end_at_vertex(std::uint32_t vertex, double s) const;
    PieceEnd end_at_rim(const Crossings& crossings, std::uint32_t id) const;
    std::uint32_t walk(const Crossings& crossings, std::uint32_t from, bool forward) const;
    void add_rim_pieces(const OriginalEdges& edges, const Crossings& crossings, const Hole& hole, int rim);
    void add_vertex_pieces(const OriginalEdges& edges, const Crossings& crossings, const InnerVertex& inner);
    void add_spoke_pieces(const OriginalEdges& edges, const Crossings& crossings, std::uint32_t spoke_edge);

    std::vector<InnerVertex> vertices_;
    std::vector<Piece> pieces_;
    bool pieces_found_ = false;
    std::vector<std::int8_t> role_; // by edge: 0 elsewhere, 1 + rim (largest_ring is small), or -1 of a spoke
    std::vector<int> position_;     // by vertex: 0 elsewhere, 1 + ring position, or -(1 + inner vertex)
};

} // namespace meshbound
