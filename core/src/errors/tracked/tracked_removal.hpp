#pragma once

#include "errors/accounting.hpp"
#include "errors/tracked/closing_shares.hpp"
#include "errors/tracked/hole_content.hpp"
#include "errors/tracked/hole_products.hpp"
#include "retriangulation/hole_tree.hpp"
#include "errors/tracked/laying.hpp"
#include "metric/measured_rows.hpp"
#include "meshbound/options.hpp"
#include "metric/rows.hpp"
#include "errors/tracked/settling.hpp"
#include "errors/tracked/tracked_cost.hpp"
#include "errors/tracked/tracked_map.hpp"

namespace meshbound {

/// One removal after another on the tracked map: what lies in the hole settles and is laid over the new triangles, the errors
/// against the original are measured there, and the map is changed accordingly.
class TrackedRemoval final : public RemovalAccounting {
public:
    TrackedRemoval(const Rows& rows, const MeasuredRows& measured_rows, const Surface& surface, TrackedMap& map,
                   const Options& options, double content_with);

    void enter(const Hole& hole) override;
    void join(const std::vector<RemovalAccounting*>& parts, double squared_limit) override;
    HoleCost& cost() override { return cost_; }
    Measured measure(const Retriangulation& retriangulation, double squared_limit) override;
    void commit(const Retriangulation& retriangulation) override;
    bool minds_turns() const override { return false; }
    std::size_t work() const override;

private:
    void fetch_ahead() const;
    void commit_settlements(const Retriangulation& retriangulation);
    void commit_piece(const Retriangulation& retriangulation, std::size_t p);

    const Rows& rows_;
    const MeasuredRows& measured_rows_;
    const Surface& surface_;
    TrackedMap& map_;
    Crossings::Supply supply_;
    bool choose_places_;
    double content_with_;
    HoleContent content_;
    HoleProducts products_;
    TrackedCost cost_;
    HoleTree tree_;
    Settling settling_;
    Laying laying_;
    const Hole* hole_ = nullptr;
};

} // namespace meshbound
