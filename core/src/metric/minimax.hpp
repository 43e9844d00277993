#pragma once

#include <vector>

#include <glm/vec2.hpp>

#include "metric/measured_rows.hpp"
#include "metric/plane_products.hpp"

namespace meshbound {

/// The place where the LARGEST of the variables' ratios to their bounds is least: what the promise is about, where the sum of
/// their squares, which nearest places go by, is only close to it.
class Minimax {
public:
    explicit Minimax(const MeasuredRows& rows) : rows_(rows) {}

    /// The places asked about next are those of w − x u − y v; `lanes(i)` has lane i of the three.
    template <class Lanes>
    void enter(const Lanes& lanes) {
        variables_.clear();
        rows_.sum_by_variable<LaneProducts>(lanes,
                                            [&](const PlaneProducts& products) { variables_.push_back(products); });
    }

    struct Place {
        glm::dvec2 at{0, 0};
        double squared_ratio; ///< the largest over the variables
    };

    /// Makes a place better by Lawson's algorithm (C. L. Lawson, 1961): least squares with a weight for each variable, which
    /// grows with what is left of it. `nearest(products)` solves one of them within the places that are allowed. Leaves
    /// `best` where it finds none below its ratio.
    template <class Nearest>
    void improve(Place& best, const Nearest& nearest) {
        weights_.assign(variables_.size(), 1 / static_cast<double>(variables_.size()));
        for (int round = 0; round < most_rounds; ++round)
            if (!weigh(nearest(weighted()), best)) return;
    }

private:
    /// More leave no fewer triangles.
    static constexpr int most_rounds = 8;

    PlaneProducts weighted() const;
    bool weigh(const glm::dvec2& at, Place& best);

    const MeasuredRows& rows_;
    std::vector<PlaneProducts> variables_;
    std::vector<double> weights_; // by variable; they add up to 1
};

} // namespace meshbound
