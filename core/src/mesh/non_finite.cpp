#include "mesh/non_finite.hpp"

namespace meshbound {

Status non_finite_at(Fault fault, const VariableView& variable, std::size_t vertex) {
    bool is_nan = false;
    for (int component = 0; component < variable.components; ++component)
        is_nan = is_nan || std::isnan(value_at(variable, vertex, component));
    const std::string name(variable.name);
    return {fault,
            "The variable “" + name + "” is " + (is_nan ? "not a number" : "infinite") + " at vertex " +
                std::to_string(vertex) + (fault == Fault::non_finite_value ? "; so it can have no bound." : "."),
            name, vertex};
}

} // namespace meshbound
