#pragma once

#include <vector>

#include "errors/error_interval.hpp"
#include "errors/error_model.hpp"
#include "errors/propagated/mapping.hpp"
#include "meshbound/options.hpp"

namespace meshbound {

/// Propagates errors through one removal after another: from the old triangles' intervals to the new ones'.
class PropagatedRemoval final : public RemovalErrorModel, private HoleCost {
public:
    /// `intervals`: [slot * (width of a row + 1) + component].
    /// `least`: by slot the least multiplier; empty where the bounds do not vary.
    PropagatedRemoval(const Rows& rows, std::vector<ErrorInterval>& intervals, std::vector<double>& least,
                      RetriangulationCost cost);

    void enter(const Hole& hole) override;
    /// Closing edges are parameterized by length, which is the same for all stars.
    void share_closing_edges(const std::vector<RemovalErrorModel*>&, double) override {}
    HoleCost& cost() override { return *this; }
    RemovalError measure(const Retriangulation& retriangulation, double squared_limit) override;
    void commit(const Retriangulation& retriangulation) override;
    std::size_t work() const override { return 1; }

private:
    double diagonal(int i, int j) override;
    double triangle(int a, int m, int b, double limit) override;

    void propagate(int a, int m, int b, ErrorInterval* fresh);
    void add_piece(int a, int m, int b, int sector, const double* candidate, ErrorInterval* fresh);
    double least_multiplier(int a, int m, int b) const;
    RemovalError worst(const ErrorInterval* intervals, double multiplier) const;
    std::size_t width() const { return static_cast<std::size_t>(rows_.width()) + 1; }

    const Rows& rows_;
    std::vector<ErrorInterval>& intervals_;
    std::vector<double>& least_;
    RetriangulationCost cost_;
    const Hole* hole_ = nullptr;
    StarMap map_;
    std::vector<ErrorInterval> fresh_; // as intervals_, for the new triangles of the removal measured last
    std::vector<double> fresh_least_;  // as least_, for the same
    std::vector<ErrorInterval> introduced_;
};

} // namespace meshbound
