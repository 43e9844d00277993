#include <algorithm>
#include <cmath>

#include "scene.hpp"

namespace {

using euler::Primitive;

constexpr double gas_constant = 8.314e-6; ///< MPa m^3 / (mol K)
constexpr double xenon = 0.1313;          ///< molar masses, kg / mol
constexpr double argon = 0.0399;
constexpr double helium = 0.0040;

/// A ball of gas.
struct Ball {
    std::array<double, 3> centre;  ///< m
    std::array<double, 3> radius;  ///< m
    double molar_mass;             ///< kg / mol
    double temperature;            ///< K
    std::array<float, 3> velocity; ///< km / s
    std::array<float, euler::tracers> fraction;
};

constexpr double fireball_pressure = 0.15; ///< MPa
constexpr double ambient_pressure = 0.1;
constexpr double ambient_temperature = 900; ///< K

const std::array<Ball, 2> balls = {{
    {{-16, -4.8, -0.8}, {11.0, 8.0, 7.4}, xenon, 1200, {1.5F, 0, 0}, {1, 0}},
    {{16, 4.8, 0.4}, {12.0, 8.5, 8.0}, argon, 400, {-1.5F, 0, 0}, {0, 1}},
}};

double density_of(double pressure, double molar_mass, double temperature) {
    return pressure * molar_mass / (gas_constant * temperature);
}

/// The balls thin out into the helium from this share of their radius inside to the same share outside: hot gas has no sharp
/// edge, and a surface of density within the fringe carries smooth fields, as the paper's does.
constexpr double fringe = 0.6;

/// 1 within the ball, 0 outside, smooth across its fringe.
double share_of(const Ball& ball, double x, double y, double z) {
    const double dx = (x - ball.centre[0]) / ball.radius[0];
    const double dy = (y - ball.centre[1]) / ball.radius[1];
    const double dz = (z - ball.centre[2]) / ball.radius[2];
    const double distance = std::sqrt(dx * dx + dy * dy + dz * dz);
    const double inside = std::clamp((1 + fringe - distance) / (2 * fringe), 0.0, 1.0);
    return inside * inside * (3 - 2 * inside);
}

/// The ball's gas at this share of its density in the helium; momentum is shared by all the mass there.
Primitive mixed(const Ball& ball, double share) {
    const double gas = share * density_of(fireball_pressure, ball.molar_mass, ball.temperature);
    const double rest = (1 - share) * density_of(ambient_pressure, helium, ambient_temperature);
    const auto fraction = float(gas / (gas + rest));
    Primitive state{float(gas + rest), ball.velocity,
                    float(ambient_pressure + share * (fireball_pressure - ambient_pressure)), ball.fraction};
    for (float& component : state.velocity) component *= fraction;
    for (float& tracer : state.fraction) tracer *= fraction;
    return state;
}

Primitive initial(double x, double y, double z) {
    for (const auto& ball : balls)
        if (const double share = share_of(ball, x, y, z); share > 0) return mixed(ball, share);
    return {float(density_of(ambient_pressure, helium, ambient_temperature)), {}, float(ambient_pressure), {}};
}

float temperature(const Primitive& state) {
    // The fractions are carried one by one, so their sum may exceed 1 a little where all three gases meet.
    const double rest = std::max(0.0, 1.0 - state.fraction[0] - state.fraction[1]);
    const double moles_per_mass = state.fraction[0] / xenon + state.fraction[1] / argon + rest / helium;
    return float(state.pressure / (state.density * gas_constant * moles_per_mass));
}

constexpr double gamma_monatomic = 5.0 / 3.0;

float energy(const Primitive& s) {
    const double speed2 = double(s.velocity[0]) * s.velocity[0] + double(s.velocity[1]) * s.velocity[1] +
                          double(s.velocity[2]) * s.velocity[2];
    return float(s.pressure / (gamma_monatomic - 1) + 0.5 * s.density * speed2);
}

} // namespace

/// Two balls of noble gas, xenon and argon, collide off-axis in hot, thin helium at 3 km/s. Lengths in metres, times in
/// milliseconds.
Scene fireballs() {
    return {"fireballs",
            "m",
            {-35, -20, -12.5},
            70,
            gamma_monatomic,
            euler::Boundary::outflow,
            12,
            initial,
            {{"density", "kg/m3", [](const Primitive& s) { return s.density; }},
             {"pressure", "MPa", [](const Primitive& s) { return s.pressure; }},
             {"vx", "km/s", [](const Primitive& s) { return s.velocity[0]; }},
             {"vy", "km/s", [](const Primitive& s) { return s.velocity[1]; }},
             {"vz", "km/s", [](const Primitive& s) { return s.velocity[2]; }},
             {"energy", "MJ/m3", energy},
             {"temperature", "K", temperature}}};
}
