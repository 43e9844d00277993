#include "scene.hpp"

/// Sod's shock tube along x, whose exact solution is known: the check of the solver.
Scene shock_tube() {
    const auto initial = [](double x, double, double) {
        euler::Primitive state;
        state.density = x < 0.5 ? 1.0F : 0.125F;
        state.pressure = x < 0.5 ? 1.0F : 0.1F;
        state.fraction = {x < 0.5 ? 1.0F : 0.0F, 0.0F};
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
             {"velocity", "1", [](const euler::Primitive& s) { return s.velocity[0]; }},
             {"pressure", "1", [](const euler::Primitive& s) { return s.pressure; }},
             {"fraction", "1", [](const euler::Primitive& s) { return s.fraction[0]; }}}};
}
