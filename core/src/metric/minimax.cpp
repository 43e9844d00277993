#include "metric/minimax.hpp"

#include <algorithm>
#include <cmath>

namespace meshbound {

PlaneProducts Minimax::weighted() const {
    PlaneProducts sum;
    for (std::size_t n = 0; n < variables_.size(); ++n) sum.add(variables_[n], weights_[n]);
    return sum;
}

/// Evaluates the weights' own optimum and sets the next weights. False when no further round can help: the weighted
/// mean at this optimum is a lower bound of the largest ratio anywhere.
bool Minimax::reweight(const glm::dvec2& parameters, Solution& best) {
    double largest = 0, mean = 0, sum = 0;
    for (std::size_t n = 0; n < variables_.size(); ++n) {
        const double square = std::max(0.0, variables_[n].squared_at(parameters));
        largest = std::max(largest, square);
        mean += weights_[n] * square;
        weights_[n] *= std::sqrt(square);
        sum += weights_[n];
    }
    if (largest < best.squared_ratio) best = {parameters, largest};
    if (!(sum > 0) || mean >= best.squared_ratio) return false;
    for (double& weight : weights_) weight /= sum;
    return true;
}

} // namespace meshbound
