#pragma once

#include <memory>
#include <vector>

#include "errors/error_interval.hpp"
#include "errors/error_model.hpp"
#include "meshbound/options.hpp"
#include "metric/rows.hpp"
#include "surface/surface.hpp"

namespace meshbound {

/// The paper's error propagation (§3.3.3, figure 6). Each triangle carries, for each component of the row and for the
/// signed distance, an interval [lowest, highest] that contains the signed error of every point that was ever mapped
/// into it. A new triangle gets, over all pieces that reach it, the old triangle's interval plus what the piece's
/// corners introduce.
///
/// Where the bounds vary, a triangle carries the least multiplier of all points that were ever mapped into it, too, and its
/// errors are measured by that.
///
/// Beyond the paper: the displacement is propagated by components and bounded by the corner of its box, since a sum of
/// distances along normals that differ from step to step bounds nothing. The signed distance is kept as a diagnostic.
class Propagation final : public ErrorModel {
public:
    Propagation(const Rows& rows, const Surface& surface, RetriangulationCost cost);

    std::unique_ptr<RemovalErrorModel> make_removal_model() override;
    void set_bounds(const Rows& rows) override;
    void errors(std::uint32_t slot, std::vector<ErrorRange>& ranges) const override;

private:
    std::size_t width() const { return static_cast<std::size_t>(rows_->width()) + 1; }

    const Rows* rows_;
    RetriangulationCost cost_;
    std::vector<ErrorInterval> intervals_; // [slot * width + component]
    std::vector<double> least_;            // by slot: the multiplier of every point mapped into it is no lower
};

} // namespace meshbound
