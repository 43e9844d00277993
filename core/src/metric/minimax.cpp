#include "metric/minimax.hpp"

#include <algorithm>
#include <cmath>

namespace meshbound {

PlaneProducts Minimax::weighted() const {
    PlaneProducts sum;
    for (std::size_t n = 0; n < variables_.size(); ++n) sum.add(variables_[n], weights_[n]);
    return sum;
}

/// Looks at the place that the weights led to, and sets the next weights. False when going on is in vain: the weighted mean at
/// the weights' own best place is below the largest ratio at any place.
bool Minimax::weigh(const glm::dvec2& at, Place& best) {
    double largest = 0, mean = 0, sum = 0;
    for (std::size_t n = 0; n < variables_.size(); ++n) {
        const double square = std::max(0.0, variables_[n].squared_at(at));
        largest = std::max(largest, square);
        mean += weights_[n] * square;
        weights_[n] *= std::sqrt(square);
        sum += weights_[n];
    }
    if (largest < best.squared_ratio) best = {at, largest};
    if (!(sum > 0) || mean >= best.squared_ratio) return false;
    for (double& weight : weights_) weight /= sum;
    return true;
}

} // namespace meshbound
