#pragma once

#include "errors/error_model.hpp"
#include "errors/tracked/closing_shares.hpp"
#include "errors/tracked/edge_tracing.hpp"
#include "errors/tracked/hole_products.hpp"
#include "errors/tracked/mapped_content.hpp"
#include "errors/tracked/tracked_cost.hpp"
#include "errors/tracked/tracked_map.hpp"
#include "errors/tracked/vertex_relocation.hpp"
#include "meshbound/options.hpp"
#include "metric/bounded_rows.hpp"
#include "metric/rows.hpp"
#include "retriangulation/dual_tree.hpp"

namespace meshbound {

/// Measures one removal after another by the tracked map: relocates the vertices and traces the edges in the hole over
/// the new triangles, measures the errors against the original there, and updates the map.
class TrackedRemoval final : public RemovalErrorModel {
public:
    TrackedRemoval(const Rows& rows, const BoundedRows& bounded_rows, const Surface& surface, TrackedMap& map,
                   const Options& options, double relocation_threshold);

    void enter(const Hole& hole) override;
    void share_closing_edges(const std::vector<RemovalErrorModel*>& models, double squared_limit) override;
    HoleCost& cost() override { return cost_; }
    RemovalError measure(const Retriangulation& retriangulation, double squared_limit) override;
    void commit(const Retriangulation& retriangulation) override;
    bool limits_normal_deviation() const override { return false; }
    std::size_t work() const override;

private:
    void prefetch_ahead() const;
    void commit_images(const Retriangulation& retriangulation);
    void commit_segment(const Retriangulation& retriangulation, std::size_t p);

    const Rows& rows_;
    const BoundedRows& bounded_rows_;
    const Surface& surface_;
    TrackedMap& map_;
    Crossings::FreeList free_list_;
    bool optimize_images_;
    double relocation_threshold_;
    MappedContent content_;
    HoleProducts products_;
    TrackedCost cost_;
    DualTree tree_;
    VertexRelocation relocation_;
    EdgeTracing tracing_;
    const Hole* hole_ = nullptr;
};

} // namespace meshbound
