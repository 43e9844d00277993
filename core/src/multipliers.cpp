#include "multipliers.hpp"

namespace meshbound {

Multipliers::Multipliers(const Variable* focus, const std::vector<std::uint32_t>& inputs) {
    if (!focus) return;
    const std::size_t vertices = inputs.empty() ? value_count(*focus) : inputs.size();
    at_vertex_.reserve(vertices);
    for (std::size_t vertex = 0; vertex < vertices; ++vertex)
        at_vertex_.push_back(value_at(*focus, inputs.empty() ? vertex : inputs[vertex], 0));
    least_ = *std::min_element(at_vertex_.begin(), at_vertex_.end());
    most_ = *std::max_element(at_vertex_.begin(), at_vertex_.end());
}

} // namespace meshbound
