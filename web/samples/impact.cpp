#include "scene.hpp"

namespace {

using euler::Primitive;

/// A strong shock in a gamma-law gas runs at (gamma + 1) / 2 = 1.33 times the speed behind it, one in aluminium at 1.34
/// times (plus its speed of sound, which is small here). Strength, melting and ionization are left out.
constexpr double gamma_metal = 5.0 / 3.0;
constexpr double heat_aluminium = 0.90e-3; ///< specific heats, (km/s)^2 / K
constexpr double heat_iron = 0.45e-3;

constexpr float density_aluminium = 2.7F; ///< g / cm^3
constexpr float density_iron = 7.8F;
constexpr float density_around = 0.05F;

/// GPa. Gives aluminium 300 K. The thin hot gas around, at the same pressure, holds the metals together at first.
constexpr float rest_pressure = 0.5F;

constexpr std::array<double, 3> ball_centre = {-5, -1.6, -0.8}; ///< mm
constexpr double ball_radius = 4.6;
constexpr std::array<float, 3> ball_velocity = {16, 2, 1}; ///< km / s
constexpr double plate_thickness = 3;                      ///< mm, from x = 0

Primitive initial(double x, double y, double z) {
    const double dx = x - ball_centre[0];
    const double dy = y - ball_centre[1];
    const double dz = z - ball_centre[2];
    if (dx * dx + dy * dy + dz * dz < ball_radius * ball_radius) {
        return {density_iron, ball_velocity, rest_pressure, {1, 0}};
    }
    if (x > 0 && x < plate_thickness) {
        return {density_aluminium, {}, rest_pressure, {0, 1}};
    }
    return {density_around, {}, rest_pressure, {}};
}

float temperature(const Primitive& state) {
    const double heat = state.fraction[0] * heat_iron + (1 - state.fraction[0]) * heat_aluminium;
    return float(state.pressure / ((gamma_metal - 1) * state.density * heat));
}

} // namespace

/// An iron ball strikes an aluminium plate obliquely at 16 km/s. Lengths in millimetres, times in microseconds.
Scene impact() {
    return {"impact",
            "mm",
            {-14, -12, -12},
            54,
            gamma_metal,
            euler::Boundary::outflow,
            1.62,
            initial,
            {{"density", "g/cm3", [](const Primitive& s) { return s.density; }},
             {"pressure", "GPa", [](const Primitive& s) { return s.pressure; }},
             {"vx", "km/s", [](const Primitive& s) { return s.velocity[0]; }},
             {"vy", "km/s", [](const Primitive& s) { return s.velocity[1]; }},
             {"vz", "km/s", [](const Primitive& s) { return s.velocity[2]; }},
             {"temperature", "K", temperature},
             {"iron", "1", [](const Primitive& s) { return s.fraction[0]; }}}};
}
