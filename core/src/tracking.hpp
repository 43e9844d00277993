#pragma once

#include <memory>
#include <vector>

#include "accounting.hpp"
#include "measured_rows.hpp"
#include "meshbound/options.hpp"
#include "tracked_map.hpp"

namespace meshbound {

/// The tracked accounting (beyond the paper): keeps the map Φ from the original surface to the current one and measures
/// against the original at every step, so that nothing accumulates.
class Tracking final : public Accounting {
public:
    Tracking(const Rows& rows, const Surface& surface, const Options& options);

    std::unique_ptr<RemovalAccounting> removals() override;
    void measure_in(const Rows& rows) override;
    void errors(std::uint32_t slot, std::vector<ErrorRange>& ranges) const override;

    const TrackedMap& map() const { return map_; }

private:
    const Rows* rows_;
    MeasuredRows measured_rows_;
    const Surface& surface_;
    const Options& options_;
    TrackedMap map_;
};

} // namespace meshbound
