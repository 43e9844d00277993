#include "errors/tracked/tracked_removal.hpp"

#include "util/indexing.hpp"

namespace meshbound {

TrackedRemoval::TrackedRemoval(const Rows& rows, const MeasuredRows& measured_rows, const Surface& surface,
                               TrackedMap& map, const Options& options, double content_with)
    : rows_(rows), measured_rows_(measured_rows), surface_(surface), map_(map), supply_(map.crossings),
      choose_places_(options.choose_places), content_with_(content_with), content_(surface), products_(measured_rows),
      cost_(measured_rows, products_), settling_(measured_rows, products_, options.choose_places),
      laying_(measured_rows, products_, map, options.choose_crossings) {}

void TrackedRemoval::enter(const Hole& hole) {
    hole_ = &hole;
    content_.enter(rows_, surface_, map_.residents, hole);
    fetch_ahead();
    products_.enter(hole, content_.vertices());
    cost_.enter(hole, content_.vertices());
}

/// What is known of the inner vertices lies scattered in memory: it is on its way while the hole is looked at:
/// of a million triangles that saves 5 % of the time.
void TrackedRemoval::fetch_ahead() const {
    for (const InnerVertex& inner : content_.vertices()) {
        measured_rows_.fetch(inner.vertex);
        map_.edges.fetch_start(inner.vertex);
    }
}

void TrackedRemoval::join(const std::vector<RemovalAccounting*>& parts, double squared_limit) {
    std::vector<ClosingShares::Part> joined;
    for (RemovalAccounting* part : parts) {
        auto& tracked = static_cast<TrackedRemoval&>(*part);
        joined.push_back({tracked.hole_, &tracked.content_});
    }
    ClosingShares(surface_, measured_rows_, choose_places_)
        .agree(joined, content_with_ * content_with_ * squared_limit);
}

std::size_t TrackedRemoval::work() const { return 1 + content_.vertices().size() / 8; }

Measured TrackedRemoval::measure(const Retriangulation& retriangulation, double squared_limit) {
    WorstError worst(measured_rows_, squared_limit, content_with_);
    tree_.enter(*hole_, retriangulation);
    if (!settling_.settle(*hole_, tree_, retriangulation, content_.vertices(), worst)) return worst.measured();
    content_.find_pieces(map_.edges, map_.crossings, *hole_);
    laying_.lay(*hole_, tree_, settling_, content_.pieces(), worst);
    return worst.measured();
}

void TrackedRemoval::commit(const Retriangulation& retriangulation) {
    for (const std::uint32_t slot : hole_->slots) map_.residents.clear_triangle(slot);
    for (const std::uint32_t edge : hole_->spoke_edges) {
        map_.crossings.clear(edge, supply_);
        map_.residents.clear_edge(edge);
    }
    commit_settlements(retriangulation);
    for (std::size_t p = 0; p < content_.pieces().size(); ++p)
        if (content_.pieces()[p].crosses || laying_.crosses(p)) commit_piece(retriangulation, p);
}

void TrackedRemoval::commit_settlements(const Retriangulation& retriangulation) {
    for (std::size_t i = 0; i < content_.vertices().size(); ++i) {
        const InnerVertex& inner = content_.vertices()[i];
        const Settling::Settlement& settlement = settling_.settlements()[i];
        const NewTriangle& triangle = retriangulation.triangles[at(settlement.triangle)];
        if (inner.host == InnerVertex::Host::triangle) {
            map_.residents.settle_in_triangle(inner.vertex, triangle.slot, settlement.weight);
        } else if (inner.host == InnerVertex::Host::closing) {
            const bool canonical = hole_->ring.front() < hole_->ring.back();
            map_.residents.settle_on_edge(inner.vertex, triangle.edge,
                                          canonical ? settlement.weight.z : 1 - settlement.weight.z);
        }
    }
}

void TrackedRemoval::commit_piece(const Retriangulation& retriangulation, std::size_t p) {
    const Piece& piece = content_.pieces()[p];
    std::uint32_t before = piece.start.crossing;
    for (std::size_t n = laying_.begin(p); n < laying_.begin(p + 1); ++n) {
        const NewCrossing& fresh = laying_.crossings()[n];
        const NewTriangle& triangle = retriangulation.triangles[at(fresh.triangle)];
        const bool canonical = hole_->ring[at(triangle.a)] < hole_->ring[at(triangle.b)];
        Crossing crossing{};
        crossing.s = fresh.s;
        crossing.t = canonical ? fresh.t : 1 - fresh.t;
        crossing.original = piece.original;
        crossing.current = triangle.edge;
        crossing.rightward = fresh.into == canonical; // the triangle lies on the right of its diagonal a → b
        const std::uint32_t id = map_.crossings.add(crossing, supply_);
        map_.crossings.link(piece.original, before, id);
        before = id;
    }
    map_.crossings.link(piece.original, before, piece.end.crossing);
}

} // namespace meshbound
