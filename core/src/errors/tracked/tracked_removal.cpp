#include "errors/tracked/tracked_removal.hpp"

#include "util/indexing.hpp"

namespace meshbound {

TrackedRemoval::TrackedRemoval(const Rows& rows, const BoundedRows& bounded_rows, const Surface& surface,
                               TrackedMap& map, const Options& options, double relocation_threshold)
    : rows_(rows), bounded_rows_(bounded_rows), surface_(surface), map_(map), free_list_(map.crossings),
      optimize_images_(options.optimize_vertex_images), relocation_threshold_(relocation_threshold), content_(surface),
      products_(bounded_rows), cost_(bounded_rows, products_),
      relocation_(bounded_rows, products_, options.optimize_vertex_images),
      tracing_(bounded_rows, products_, map, options.optimize_edge_crossings) {}

void TrackedRemoval::enter(const Hole& hole) {
    hole_ = &hole;
    content_.enter(rows_, surface_, map_.mapped_vertices, hole);
    prefetch_ahead();
    products_.enter(hole, content_.vertices());
    cost_.enter(hole, content_.vertices());
}

/// The data of the inner vertices lie scattered in memory: prefetched here, they arrive while the hole is being
/// prepared.
void TrackedRemoval::prefetch_ahead() const {
    for (const InnerVertex& inner : content_.vertices()) {
        bounded_rows_.prefetch(inner.vertex);
        map_.edges.prefetch_start(inner.vertex);
    }
}

void TrackedRemoval::share_closing_edges(const std::vector<RemovalErrorModel*>& models, double squared_limit) {
    std::vector<ClosingShares::Star> stars;
    for (RemovalErrorModel* model : models) {
        auto& tracked = static_cast<TrackedRemoval&>(*model);
        stars.push_back({tracked.hole_, &tracked.content_});
    }
    ClosingShares(surface_, bounded_rows_, optimize_images_)
        .agree(stars, relocation_threshold_ * relocation_threshold_ * squared_limit);
}

std::size_t TrackedRemoval::work() const { return 1 + content_.vertices().size() / 8; }

RemovalError TrackedRemoval::measure(const Retriangulation& retriangulation, double squared_limit) {
    WorstError worst(bounded_rows_, squared_limit, relocation_threshold_);
    tree_.enter(*hole_, retriangulation);
    if (!relocation_.relocate(*hole_, tree_, retriangulation, content_.vertices(), worst)) return worst.measured();
    content_.find_segments(map_.edges, map_.crossings, *hole_);
    tracing_.trace(*hole_, tree_, relocation_, content_.segments(), worst);
    return worst.measured();
}

void TrackedRemoval::commit(const Retriangulation& retriangulation) {
    for (const std::uint32_t slot : hole_->slots) map_.mapped_vertices.clear_triangle(slot);
    for (const std::uint32_t edge : hole_->spoke_edges) {
        map_.crossings.clear(edge, free_list_);
        map_.mapped_vertices.clear_edge(edge);
    }
    commit_images(retriangulation);
    for (std::size_t p = 0; p < content_.segments().size(); ++p)
        if (content_.segments()[p].crosses || tracing_.crosses(p)) commit_segment(retriangulation, p);
}

void TrackedRemoval::commit_images(const Retriangulation& retriangulation) {
    for (std::size_t i = 0; i < content_.vertices().size(); ++i) {
        const InnerVertex& inner = content_.vertices()[i];
        const VertexRelocation::VertexImage& image = relocation_.images()[i];
        const NewTriangle& triangle = retriangulation.triangles[to_index(image.triangle)];
        if (inner.container == InnerVertex::Container::triangle) {
            map_.mapped_vertices.put_in_triangle(inner.vertex, triangle.slot, image.weight);
        } else if (inner.container == InnerVertex::Container::closing_edge) {
            const bool canonical = hole_->ring.front() < hole_->ring.back();
            map_.mapped_vertices.put_on_edge(inner.vertex, triangle.edge,
                                             canonical ? image.weight.z : 1 - image.weight.z);
        }
    }
}

void TrackedRemoval::commit_segment(const Retriangulation& retriangulation, std::size_t p) {
    const EdgeSegment& segment = content_.segments()[p];
    std::uint32_t before = segment.start.crossing;
    for (std::size_t n = tracing_.begin(p); n < tracing_.begin(p + 1); ++n) {
        const NewCrossing& fresh = tracing_.crossings()[n];
        const NewTriangle& triangle = retriangulation.triangles[to_index(fresh.triangle)];
        const bool canonical = hole_->ring[to_index(triangle.a)] < hole_->ring[to_index(triangle.b)];
        Crossing crossing{};
        crossing.s = fresh.s;
        crossing.t = canonical ? fresh.t : 1 - fresh.t;
        crossing.original = segment.original;
        crossing.current = triangle.edge;
        crossing.rightward = fresh.into == canonical; // the triangle lies on the right of its diagonal a → b
        const std::uint32_t id = map_.crossings.add(crossing, free_list_);
        map_.crossings.link(segment.original, before, id);
        before = id;
    }
    map_.crossings.link(segment.original, before, segment.end.crossing);
}

} // namespace meshbound
