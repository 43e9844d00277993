#pragma once

#include <vector>

#include "errors/tracked/hole_products.hpp"
#include "errors/tracked/joint_space.hpp"
#include "errors/tracked/mapped_content.hpp"
#include "errors/tracked/tracked_map.hpp"
#include "errors/tracked/vertex_relocation.hpp"
#include "errors/tracked/worst_error.hpp"
#include "metric/bounded_rows.hpp"
#include "metric/minimax.hpp"
#include "retriangulation/dual_tree.hpp"

namespace meshbound {

/// A crossing with a new diagonal: that of `triangle` to its parent, t from its ring index a to b.
struct NewCrossing {
    int triangle = 0;
    double s = 0, t = 0;
    bool into = false; ///< passes into this triangle as s rises
};

/// Traces the segments of original edges in a hole over its new triangles: each from the triangle of its start to that
/// of its end, straight in the layout or, where the error is too high there and crossings are optimized, where it is
/// smallest.
class EdgeTracing {
public:
    EdgeTracing(const BoundedRows& rows, const HoleProducts& products, const TrackedMap& map, bool optimize_crossings)
        : rows_(rows), products_(products), map_(map), optimize_crossings_(optimize_crossings), minimax_(rows) {}

    /// Traces all segments, after the inner vertices are relocated; false as soon as an error is above the limit.
    bool trace(const Hole& hole, DualTree& tree, const VertexRelocation& relocation,
               const std::vector<EdgeSegment>& segments, WorstError& worst);

    /// The crossings of a segment, with s rising: [begin(p), begin(p + 1)) of all.
    const std::vector<NewCrossing>& crossings() const { return crossings_; }
    std::size_t begin(std::size_t segment) const { return begin_[segment]; }
    bool crosses(std::size_t segment) const { return begin(segment) < begin(segment + 1); }

private:
    bool trace_segment(const EdgeSegment& segment, int from, int to, WorstError& worst);
    /// The triangle in which a segment begins or ends. At a ring vertex any of its triangles will do.
    int triangle_at(const SegmentEnd& end) const {
        return end.is_inner() ? relocation_->triangle_of(end.inner())
                              : tree_->at_link_edge(end.is_crossing() ? end.link_edge() : end.ring());
    }
    glm::dvec2 layout_of(const SegmentEnd& end) const;
    double start_of(const EdgeSegment& segment) const;
    double end_of(const EdgeSegment& segment) const;
    void cross_straight(const EdgeSegment& segment, std::size_t first);
    void optimize(const EdgeSegment& segment, std::size_t first, std::size_t n, double squared_threshold,
                  double& error);
    void replace_if_better(const EdgeSegment& segment, const glm::dvec2& chosen, NewCrossing& crossing,
                           double& error) const;
    auto difference(const EdgeSegment& segment, const NewCrossing& crossing) const;
    double error(const EdgeSegment& segment, const NewCrossing& crossing) const;

    const BoundedRows& rows_;
    const HoleProducts& products_;
    const TrackedMap& map_;
    bool optimize_crossings_;
    Minimax minimax_;
    const Hole* hole_ = nullptr;
    DualTree* tree_ = nullptr;
    const VertexRelocation* relocation_ = nullptr;
    std::vector<NewCrossing> crossings_; // segment after segment
    std::vector<std::size_t> begin_;     // by segment: its first crossing
};

} // namespace meshbound
