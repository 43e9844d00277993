#pragma once

#include <cmath>
#include <string>

#include "meshbound/mesh.hpp"
#include "meshbound/status.hpp"

namespace meshbound {

/// Whether all components of a variable are numbers at a vertex, neither NaN nor infinite.
inline bool is_finite_at(const VariableView& variable, std::size_t vertex) {
    for (int component = 0; component < variable.components; ++component)
        if (!std::isfinite(value_at(variable, vertex, component))) return false;
    return true;
}

/// Calls a variable at fault for what stands at a vertex. `fault` is non_finite_position or non_finite_value.
Status non_finite_at(Fault fault, const VariableView& variable, std::size_t vertex);

} // namespace meshbound
