#pragma once

#include <memory>
#include <vector>

#include "errors/accounting.hpp"
#include "metric/measured_rows.hpp"
#include "meshbound/options.hpp"
#include "errors/tracked/tracked_map.hpp"

namespace meshbound {

/// The tracked accounting (beyond the paper): keeps the map Φ from the original surface to the current one and measures
/// against the original at every step, so that nothing accumulates.
class Tracking final : public Accounting {
public:
    /// `content_with`: what the map puts somewhere by the layout stays there up to this share of the limit. For the promise 1
    /// is enough: looking on below leaves no fewer triangles, and makes folds in the map for nothing.
    Tracking(const Rows& rows, const Surface& surface, const Options& options, double content_with = 1);

    std::unique_ptr<RemovalAccounting> removals() override;
    void measure_in(const Rows& rows) override;
    void errors(std::uint32_t slot, std::vector<ErrorRange>& ranges) const override;

    const TrackedMap& map() const { return map_; }

    /// Nothing is removed any more: keeps what tells of the map.
    void end() { map_.edges.forget_spokes(); }

private:
    const Rows* rows_;
    MeasuredRows measured_rows_;
    const Surface& surface_;
    const Options& options_;
    double content_with_;
    TrackedMap map_;
};

} // namespace meshbound
