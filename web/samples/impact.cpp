#include "scene.hpp"

namespace {

using euler::Primitive;

constexpr double gamma_metal = 5.0 / 3.0;
constexpr double heat_aluminium = 0.90e-3; ///< specific heats, (km/s)^2 / K
constexpr double heat_iron = 0.45e-3;
constexpr double rest_pressure = 0.5; ///< GPa

Primitive initial(double x, double y, double z) {
    const double dx = x + 5, dy = y + 1.6, dz = z + 0.8;
    if (dx * dx + dy * dy + dz * dz < 4.0 * 4.0) {
        return {7.8F, {16.0F, 2.0F, 1.0F}, float(rest_pressure), {1, 0}};
    }
    if (x > 0 && x < 3) {
        return {2.7F, {}, float(rest_pressure), {0, 1}};
    }
    return {0.05F, {}, float(rest_pressure), {}};
}

float temperature(const Primitive& s) {
    const double heat = s.fraction[0] * heat_iron + (1 - s.fraction[0]) * heat_aluminium;
    return float(s.pressure / ((gamma_metal - 1) * s.density * heat));
}

} // namespace

/// An iron ball strikes an aluminium plate obliquely. Lengths in millimetres, times in microseconds.
Scene impact() {
    return {"impact",
            "mm",
            {-14, -12, -12},
            54,
            gamma_metal,
            euler::Boundary::outflow,
            1.8,
            initial,
            {{"density", "g/cm3", [](const Primitive& s) { return s.density; }},
             {"pressure", "GPa", [](const Primitive& s) { return s.pressure; }},
             {"vx", "km/s", [](const Primitive& s) { return s.velocity[0]; }},
             {"vy", "km/s", [](const Primitive& s) { return s.velocity[1]; }},
             {"vz", "km/s", [](const Primitive& s) { return s.velocity[2]; }},
             {"temperature", "K", temperature},
             {"iron", "1", [](const Primitive& s) { return s.fraction[0]; }}}};
}
