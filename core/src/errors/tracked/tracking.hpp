#pragma once

#include <memory>
#include <vector>

#include "errors/error_model.hpp"
#include "errors/tracked/tracked_map.hpp"
#include "meshbound/options.hpp"
#include "metric/bounded_rows.hpp"

namespace meshbound {

/// Tracked errors (beyond the paper): keeps the map Φ from the original surface to the current one and measures against
/// the original at every step, so that nothing accumulates.
class Tracking final : public ErrorModel {
public:
    /// `relocation_threshold`: images and crossings are optimized where their error in the layout exceeds this share of
    /// the limit. For the guarantee 1 is enough: less does not reduce further, and folds the map for nothing.
    Tracking(const Rows& rows, const Surface& surface, const Options& options, double relocation_threshold = 1);

    std::unique_ptr<RemovalErrorModel> make_removal_model() override;
    void set_bounds(const Rows& rows) override;
    void errors(std::uint32_t slot, std::vector<ErrorRange>& ranges) const override;

    const TrackedMap& map() const { return map_; }

    /// Nothing is removed any more: releases what the map itself does not need.
    void finish() { map_.edges.release_incidence(); }

private:
    const Rows* rows_;
    BoundedRows bounded_rows_;
    const Surface& surface_;
    const Options& options_;
    double relocation_threshold_;
    TrackedMap map_;
};

} // namespace meshbound
