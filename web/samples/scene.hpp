#pragma once

#include <string>
#include <vector>

#include "euler.hpp"

/// A variable as the samples carry it, computed from the state of a cell.
struct SceneVariable {
    std::string name;
    std::string unit;
    float (*value)(const euler::Primitive& state);
};

/// A flow to be simulated: what there is at first, in which box, for how long, and what is looked at in the end.
struct Scene {
    std::string name;
    std::string length_unit;
    std::array<double, 3> origin; ///< the lowest corner of the box
    double length;                ///< of the longest side of the box; the cells are cubes
    double gamma;
    euler::Boundary boundary;
    double end; ///< time that passes, in the scene's unit
    euler::Flow::InitialState initial;
    std::vector<SceneVariable> variables;
};

Scene fireballs();
Scene impact();
Scene shock_tube();
