#include "metric/multipliers.hpp"

#include <limits>

#include "mesh/used_vertices.hpp"

namespace meshbound {

Multipliers::Multipliers(const Mesh& mesh, const Variable* bound_multiplier, const std::vector<std::uint32_t>& inputs) {
    if (!bound_multiplier) return;
    const std::vector<char> used = find_used_vertices(mesh);
    at_vertex_.resize(inputs.empty() ? used.size() : inputs.size(), 1);
    least_ = std::numeric_limits<double>::infinity();
    most_ = 0;
    for (std::size_t vertex = 0; vertex < at_vertex_.size(); ++vertex) {
        const std::size_t input = inputs.empty() ? vertex : inputs[vertex];
        if (!used[input]) continue;
        const double multiplier = value_at(*bound_multiplier, input, 0);
        at_vertex_[vertex] = multiplier;
        least_ = std::min(least_, multiplier);
        most_ = std::max(most_, multiplier);
    }
}

} // namespace meshbound
