#pragma once

#include <vector>

#include <glm/vec2.hpp>

#include "metric/bounded_rows.hpp"
#include "metric/plane_products.hpp"

namespace meshbound {

/// Minimizes the LARGEST of the variables' ratios to their bounds, which is what is guaranteed. The sum of their
/// squares, by which nearest points are found, only approximates it.
class Minimax {
public:
    explicit Minimax(const BoundedRows& rows) : rows_(rows) {}

    /// Sets the problem: w − x u − y v over (x, y); `lanes(i)` has lane i of the three.
    template <class Lanes>
    void enter(const Lanes& lanes) {
        variables_.clear();
        rows_.sum_by_variable<LaneProducts>(lanes,
                                            [&](const PlaneProducts& products) { variables_.push_back(products); });
    }

    struct Solution {
        glm::dvec2 parameters{0, 0};
        double squared_ratio; ///< the largest over the variables
    };

    /// Improves a solution by Lawson's algorithm (C. L. Lawson, 1961): iteratively reweighted least squares, with a
    /// weight for each variable that grows with its residual. `nearest(products)` solves one least-squares problem
    /// within the feasible (x, y). Leaves `best` where it finds nothing below its ratio.
    template <class Nearest>
    void improve(Solution& best, const Nearest& nearest) {
        weights_.assign(variables_.size(), 1 / static_cast<double>(variables_.size()));
        for (int round = 0; round < most_rounds; ++round)
            if (!reweight(nearest(weighted()), best)) return;
    }

private:
    /// More do not reduce further.
    static constexpr int most_rounds = 8;

    PlaneProducts weighted() const;
    bool reweight(const glm::dvec2& parameters, Solution& best);

    const BoundedRows& rows_;
    std::vector<PlaneProducts> variables_;
    std::vector<double> weights_; // by variable; they add up to 1
};

} // namespace meshbound
