#pragma once

#include <cstdint>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "errors/tracked/crossings.hpp"
#include "errors/tracked/mapped_vertices.hpp"
#include "errors/tracked/original_edges.hpp"
#include "metric/rows.hpp"
#include "surface/hole.hpp"
#include "util/linked_list_prefetcher.hpp"

namespace meshbound {

/// An original vertex whose image lies in the hole or on its boundary edges.
struct InnerVertex {
    enum class Container {
        triangle,     ///< inside the hole: it is relocated into one of the new triangles
        closing_edge, ///< on the closing edge of an open hole
        link_edge,    ///< on a link edge that is a boundary edge: it stays where it is
    };
    std::uint32_t vertex = no_index;
    Container container = Container::triangle;
    int link_edge = -1;          ///< of Container::link_edge: which one
    glm::dvec2 layout{0};        ///< in the plane
    double share = 0;            ///< of Container::closing_edge: along it, from ring index 0
    bool share_is_fixed = false; ///< of Container::closing_edge: the same on all sheets, see ClosingShares
};

/// The end of a segment: a crossing on a link edge, or a ring vertex or an inner vertex where the original edge ends,
/// too. Small, since a hole may have thousands of them.
struct SegmentEnd {
    int where = 0; ///< the link edge; of a vertex 1 + its ring index, or -(1 + index of the inner vertex)
    std::uint32_t crossing = no_index; ///< on the link edge; no_index: a vertex

    bool is_crossing() const { return crossing != no_index; }
    bool is_inner() const { return where < 0; }
    int link_edge() const { return where; }
    int inner() const { return -1 - where; }
    /// The ring index of a ring vertex, else -1.
    int ring() const { return is_crossing() || is_inner() ? -1 : where - 1; }
};

/// A segment of an original edge inside the hole: between two neighbours of the crossings and vertices on it that
/// remain when the spokes vanish.
struct EdgeSegment {
    std::uint32_t original = no_index;
    SegmentEnd start, end; ///< s rising
    bool crosses = true;   ///< any current edge, spokes included; most segments of a large hole do not
};

/// What is mapped into a hole: every original vertex and every segment of an original edge.
class MappedContent {
public:
    explicit MappedContent(const Surface& surface);

    /// Finds the inner vertices.
    void enter(const Rows& rows, const Surface& surface, const MappedVertices& mapped_vertices, const Hole& hole);
    /// Finds the segments, unless it has found those of this hole; enter comes first.
    void find_segments(const OriginalEdges& edges, const Crossings& crossings, const Hole& hole);

    /// Puts an inner vertex of the closing edge at a share of it, where it stays.
    void fix_closing_share(std::size_t inner, double share, const Hole& hole);

    const std::vector<InnerVertex>& vertices() const { return vertices_; }
    const std::vector<EdgeSegment>& segments() const { return segments_; }

private:
    void prefetch_vertices(const MappedVertices& mapped_vertices, const Hole& hole);
    void prefetch_crossings(const Crossings& crossings, const Hole& hole);
    void add_sector(const MappedVertices& mapped_vertices, const Hole& hole, int sector);
    void add_closing(const Rows& rows, const MappedVertices& mapped_vertices, const Hole& hole);
    void add_link_edge(const MappedVertices& mapped_vertices, const Hole& hole, int link_edge);
    void mark(const Hole& hole);
    void unmark(const Hole& hole);
    SegmentEnd end_at_vertex(std::uint32_t vertex) const { return {vertex_role_[vertex]}; }
    SegmentEnd end_at_link_edge(const Crossings& crossings, std::uint32_t id) const;
    std::uint32_t walk(const Crossings& crossings, std::uint32_t from, bool forward) const;
    void add_link_edge_segments(const OriginalEdges& edges, const Crossings& crossings, const Hole& hole,
                                int link_edge);
    void add_vertex_segments(const OriginalEdges& edges, const Crossings& crossings, std::uint32_t vertex);
    void add_spoke_segments(const OriginalEdges& edges, const Crossings& crossings, std::uint32_t spoke_edge);

    std::vector<InnerVertex> vertices_;
    std::vector<EdgeSegment> segments_;
    bool segments_found_ = false;
    LinkedListPrefetcher prefetcher_;
    std::vector<std::int8_t> edge_role_; // by edge: 1 + link edge, -1 of a spoke, 0 elsewhere
    std::vector<int> vertex_role_;       // by vertex: 0 elsewhere, else as in SegmentEnd::where
};

} // namespace meshbound
