#include "multipliers.hpp"

namespace meshbound {

Multipliers::Multipliers(const Variable* focus) {
    if (!focus) return;
    const std::size_t vertices = value_count(*focus);
    at_vertex_.reserve(vertices);
    for (std::size_t vertex = 0; vertex < vertices; ++vertex) at_vertex_.push_back(value_at(*focus, vertex, 0));
    least_ = *std::min_element(at_vertex_.begin(), at_vertex_.end());
    most_ = *std::max_element(at_vertex_.begin(), at_vertex_.end());
}

} // namespace meshbound
