#include <algorithm>

#include "scene.hpp"

/// Sod's shock tube along the axis that has more than one cell. Its exact solution is known: the check of the solver.
Scene shock_tube() {
    const auto initial = [](double x, double y, double z) {
        const bool driver = std::max({x, y, z}) < 0.5;
        euler::Primitive state;
        state.density = driver ? 1.0F : 0.125F;
        state.pressure = driver ? 1.0F : 0.1F;
        state.fraction = {driver ? 1.0F : 0.0F, 0.0F};
        return state;
    };
    return {"shock-tube",
            "1",
            {0, 0, 0},
            1,
            1.4,
            euler::Boundary::outflow,
            0.2,
            initial,
            {{"density", "1", [](const euler::Primitive& s) { return s.density; }},
             {"velocity", "1", [](const euler::Primitive& s) { return s.velocity[0] + s.velocity[1] + s.velocity[2]; }},
             {"pressure", "1", [](const euler::Primitive& s) { return s.pressure; }},
             {"driver", "1", [](const euler::Primitive& s) { return s.fraction[0]; }}}};
}
