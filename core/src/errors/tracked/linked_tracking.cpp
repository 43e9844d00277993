#include "errors/tracked/linked_tracking.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "errors/tracked/map_output.hpp"

namespace meshbound {
namespace {

/// The errors of a map between levels are seen in a morph. So images and crossings are optimized from this share of the
/// limit on, which is the sum of those of both levels.
constexpr double morph_relocation_threshold = 0.3;

/// The input vertices that are left; the vertices of each are consecutive.
std::vector<std::uint32_t> kept_vertices(const Surface& surface) {
    std::vector<std::uint32_t> kept;
    for (std::uint32_t vertex = 0; vertex < surface.vertex_count(); ++vertex) {
        if (surface.kind(vertex) == VertexKind::absent) continue;
        const std::uint32_t input = surface.input(vertex);
        if (kept.empty() || kept.back() != input) kept.push_back(input);
    }
    return kept;
}

/// The index of a vertex in a rising list.
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

/// Measures a removal by both maps.
class LinkedRemoval final : public RemovalErrorModel {
public:
    LinkedRemoval(std::unique_ptr<RemovalErrorModel> from_original, std::unique_ptr<RemovalErrorModel> from_finer)
        : from_original_(std::move(from_original)), from_finer_(std::move(from_finer)) {}

    void enter(const Hole& hole) override {
        from_original_->enter(hole);
        from_finer_->enter(hole);
    }

    /// Each map puts its own vertices at the same share on all stars.
    void share_closing_edges(const std::vector<RemovalErrorModel*>& models, double squared_limit) override {
        std::vector<RemovalErrorModel*> from_original, from_finer;
        for (RemovalErrorModel* model : models) {
            auto& linked = static_cast<LinkedRemoval&>(*model);
            from_original.push_back(linked.from_original_.get());
            from_finer.push_back(linked.from_finer_.get());
        }
        from_original_->share_closing_edges(from_original, squared_limit);
        from_finer_->share_closing_edges(from_finer, squared_limit);
    }

    HoleCost& cost() override { return from_original_->cost(); }

    RemovalError measure(const Retriangulation& retriangulation, double squared_limit) override {
        const RemovalError original = from_original_->measure(retriangulation, squared_limit);
        if (original.squared_ratio > squared_limit) return original;
        const RemovalError finer = from_finer_->measure(retriangulation, squared_limit);
        return finer.squared_ratio > original.squared_ratio ? finer : original;
    }

    void commit(const Retriangulation& retriangulation) override {
        from_original_->commit(retriangulation);
        from_finer_->commit(retriangulation);
    }

    bool limits_normal_deviation() const override { return from_original_->limits_normal_deviation(); }

    std::size_t work() const override { return from_original_->work() + from_finer_->work(); }

private:
    std::unique_ptr<RemovalErrorModel> from_original_, from_finer_;
};

} // namespace

LinkedTracking::LinkedTracking(Tracking& from_original, Rows rows, const Surface& surface, const Options& options)
    : from_original_(from_original), rows_(std::move(rows)),
      from_finer_(rows_, surface, options, morph_relocation_threshold), surface_(&surface),
      finer_vertices_(kept_vertices(surface)) {}

std::unique_ptr<RemovalErrorModel> LinkedTracking::make_removal_model() {
    return std::make_unique<LinkedRemoval>(from_original_.make_removal_model(), from_finer_.make_removal_model());
}

void LinkedTracking::set_bounds(const Rows& rows) { from_original_.set_bounds(rows); }

void LinkedTracking::errors(std::uint32_t slot, std::vector<ErrorRange>& ranges) const {
    from_original_.errors(slot, ranges);
}

void LinkedTracking::extract(const std::vector<std::uint32_t>& reduced_vertex,
                             const std::vector<std::uint32_t>& reduced_triangle,
                             const std::vector<std::uint32_t>& coarser_vertices, LevelMap& link,
                             ProgressReporter& reporter) const {
    const Indices in_finer(finer_vertices_);
    for (const std::uint32_t vertex : coarser_vertices) link.vertices.push_back(in_finer[vertex]);
    SurfaceMap map;
    extract_map(*surface_, from_finer_, reduced_vertex, reduced_triangle, map, reporter);
    for (const std::uint32_t vertex : finer_vertices_) link.map.images.push_back(map.images[vertex]);
    link.map.crossings = std::move(map.crossings);
    for (MapCrossing& crossing : link.map.crossings)
        crossing.original = {in_finer[crossing.original.x], in_finer[crossing.original.y]};
    extract_errors(link, reporter);
}

void LinkedTracking::extract_errors(LevelMap& link, ProgressReporter& reporter) const {
    link.errors.assign(rows_.groups().size(), 0);
    std::vector<ErrorRange> ranges;
    for (std::uint32_t slot = 0; slot < surface_->slot_count() && reporter.advance(1); ++slot) {
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
