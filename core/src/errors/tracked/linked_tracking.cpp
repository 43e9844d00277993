#include "errors/tracked/linked_tracking.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "errors/tracked/map_output.hpp"

namespace meshbound {
namespace {

/// A morph leads along the map between levels, so its errors are seen: beyond this share of the limit, which is that of both
/// levels together, places are looked for that keep it within the bounds of the coarser one.
constexpr double content_on_the_way = 0.3;

/// Vertices of the input of which copies are left; the copies of one are neighbours in the numbering.
std::vector<std::uint32_t> kept_vertices(const Surface& surface) {
    std::vector<std::uint32_t> kept;
    for (std::uint32_t vertex = 0; vertex < surface.vertex_count(); ++vertex) {
        if (surface.kind(vertex) == VertexKind::absent) continue;
        const std::uint32_t input = surface.input(vertex);
        if (kept.empty() || kept.back() != input) kept.push_back(input);
    }
    return kept;
}

/// Names vertices by their indices among some of them, which are rising.
class Indices {
public:
    explicit Indices(const std::vector<std::uint32_t>& vertices) : vertices_(vertices) {}
    std::uint32_t operator[](std::uint32_t vertex) const {
        return static_cast<std::uint32_t>(std::lower_bound(vertices_.begin(), vertices_.end(), vertex) -
                                          vertices_.begin());
    }

private:
    const std::vector<std::uint32_t>& vertices_;
};

/// A removal on both maps.
class LinkedRemoval final : public RemovalAccounting {
public:
    LinkedRemoval(std::unique_ptr<RemovalAccounting> from_original, std::unique_ptr<RemovalAccounting> from_finer)
        : from_original_(std::move(from_original)), from_finer_(std::move(from_finer)) {}

    void enter(const Hole& hole) override {
        from_original_->enter(hole);
        from_finer_->enter(hole);
    }

    /// The map from the original decides; the one from the finer level goes the same way on all parts, too.
    void join(const std::vector<RemovalAccounting*>& parts, double squared_limit) override {
        std::vector<RemovalAccounting*> from_original, from_finer;
        for (RemovalAccounting* part : parts) {
            auto& linked = static_cast<LinkedRemoval&>(*part);
            from_original.push_back(linked.from_original_.get());
            from_finer.push_back(linked.from_finer_.get());
        }
        from_original_->join(from_original, squared_limit);
        from_finer_->join(from_finer, squared_limit);
    }

    HoleCost& cost() override { return from_original_->cost(); }

    Measured measure(const Retriangulation& retriangulation, double squared_limit) override {
        const Measured original = from_original_->measure(retriangulation, squared_limit);
        if (original.squared_ratio > squared_limit) return original;
        const Measured finer = from_finer_->measure(retriangulation, squared_limit);
        return finer.squared_ratio > original.squared_ratio ? finer : original;
    }

    void commit(const Retriangulation& retriangulation) override {
        from_original_->commit(retriangulation);
        from_finer_->commit(retriangulation);
    }

    bool minds_turns() const override { return from_original_->minds_turns(); }

    std::size_t work() const override { return from_original_->work() + from_finer_->work(); }

private:
    std::unique_ptr<RemovalAccounting> from_original_, from_finer_;
};

} // namespace

LinkedTracking::LinkedTracking(Tracking& from_original, Rows rows, const Surface& surface, const Options& options)
    : from_original_(from_original), rows_(std::move(rows)), from_finer_(rows_, surface, options, content_on_the_way),
      surface_(&surface), finer_vertices_(kept_vertices(surface)) {}

std::unique_ptr<RemovalAccounting> LinkedTracking::removals() {
    return std::make_unique<LinkedRemoval>(from_original_.removals(), from_finer_.removals());
}

void LinkedTracking::measure_in(const Rows& rows) { from_original_.measure_in(rows); }

void LinkedTracking::errors(std::uint32_t slot, std::vector<ErrorRange>& ranges) const {
    from_original_.errors(slot, ranges);
}

void LinkedTracking::extract(const std::vector<std::uint32_t>& renamed_vertex,
                             const std::vector<std::uint32_t>& renamed_triangle,
                             const std::vector<std::uint32_t>& coarser_vertices, LevelLink& link,
                             Ticker& ticker) const {
    const Indices in_finer(finer_vertices_);
    for (const std::uint32_t vertex : coarser_vertices) link.vertices.push_back(in_finer[vertex]);
    SurfaceMap map;
    extract_map(*surface_, from_finer_, renamed_vertex, renamed_triangle, map, ticker);
    for (const std::uint32_t vertex : finer_vertices_) link.map.places.push_back(map.places[vertex]);
    link.map.crossings = std::move(map.crossings);
    for (MapCrossing& crossing : link.map.crossings)
        crossing.original = {in_finer[crossing.original.x], in_finer[crossing.original.y]};
    extract_errors(link, ticker);
}

void LinkedTracking::extract_errors(LevelLink& link, Ticker& ticker) const {
    link.errors.assign(rows_.groups().size(), 0);
    std::vector<ErrorRange> ranges;
    for (std::uint32_t slot = 0; slot < surface_->slot_count() && ticker.tick(1); ++slot) {
        if (!surface_->alive(slot)) continue;
        from_finer_.errors(slot, ranges);
        for (const RowGroup& group : rows_.groups()) {
            const ErrorRange& range = ranges[group.variable];
            double& largest = link.errors[group.variable];
            if (!range.known) largest = std::numeric_limits<double>::quiet_NaN();
            else if (!std::isnan(largest)) largest = std::max(largest, range.largest * rows_.unit(group));
        }
    }
}

} // namespace meshbound
