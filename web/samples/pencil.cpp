#include "pencil.hpp"

#include <algorithm>
#include <cmath>

namespace euler {
namespace {

/// Where a reconstructed density or pressure falls below this fraction of the cell's mean, the cell falls back to first
/// order: next to vacuum a straight line would soon be negative.
constexpr float smallest_fraction_at_face = 0.1F;

/// The monotonized central slope: second order where smooth, none at an extremum.
inline float limited_slope(float below, float here, float above) {
    const float left = here - below;
    const float right = above - here;
    const float steepest = 2.0F * std::min(std::fabs(left), std::fabs(right));
    const float central = 0.5F * (left + right);
    const float size = std::min(steepest, std::fabs(central));
    const float slope = central < 0.0F ? -size : size;
    return left * right > 0.0F ? slope : 0.0F;
}

/// What a flow merely carries along its direction: the other two velocities and the mass fractions.
constexpr std::array<int, 2 + tracers> carried = {2, 3, 5, 6};

/// One side of a face in a Riemann problem.
struct Side {
    float density, normal, pressure, energy, sound;
};

inline Side make_side(float density, float normal, float v, float w, float pressure, float gamma) {
    const float kinetic = 0.5F * density * (normal * normal + v * v + w * w);
    return {density, normal, pressure, pressure / (gamma - 1.0F) + kinetic, std::sqrt(gamma * pressure / density)};
}

struct Flux {
    float mass, momentum, energy;
};

/// The slowest and the fastest wave, bounded by Roe's averages (Batten et al. 1997).
inline std::array<float, 2> wave_speeds(const Side& l, const Side& r) {
    const float weight_l = std::sqrt(l.density);
    const float weight_r = std::sqrt(r.density);
    const float scale = 1.0F / (weight_l + weight_r);
    const float normal = (weight_l * l.normal + weight_r * r.normal) * scale;
    const float jump = r.normal - l.normal;
    const float sound = std::sqrt((weight_l * l.sound * l.sound + weight_r * r.sound * r.sound) * scale +
                                  0.5F * weight_l * weight_r * scale * scale * jump * jump);
    return {std::min(l.normal - l.sound, normal - sound), std::max(r.normal + r.sound, normal + sound)};
}

/// The HLLC flux (Toro, section 10.4): that of the side that the contact comes from, plus the jump across that side's
/// wave where the wave has not passed the face. Without branches, so that it vectorizes.
inline Flux hllc(const Side& l, const Side& r) {
    const auto [speed_l, speed_r] = wave_speeds(l, r);
    const float push_l = l.density * (speed_l - l.normal);
    const float push_r = r.density * (speed_r - r.normal);
    const float contact = (r.pressure - l.pressure + push_l * l.normal - push_r * r.normal) / (push_l - push_r);

    const bool from_left = contact >= 0.0F;
    const float density = from_left ? l.density : r.density;
    const float normal = from_left ? l.normal : r.normal;
    const float pressure = from_left ? l.pressure : r.pressure;
    const float energy = from_left ? l.energy : r.energy;
    const float push = from_left ? push_l : push_r;
    const float wave = from_left ? speed_l : speed_r;
    const float jump_speed = from_left ? std::min(speed_l, 0.0F) : std::max(speed_r, 0.0F);

    const float density_star = push / (wave - contact);
    const float energy_star = density_star * (energy / density + (contact - normal) * (contact + pressure / push));
    return {density * normal + jump_speed * (density_star - density),
            density * normal * normal + pressure + jump_speed * (density_star * contact - density * normal),
            (energy + pressure) * normal + jump_speed * (energy_star - energy)};
}

} // namespace

Pencil::Pencil(int cells) : cells_(cells) {
    for (Rows* rows : {&conserved_, &primitive_, &low_, &high_, &flux_}) {
        for (auto& row : *rows) {
            row.assign(std::size_t(cells) + 2 * ghosts, 0.0F);
        }
    }
}

void Pencil::step(float dt_over_spacing, float gamma, Boundary boundary) {
    fill_ghosts(boundary);
    find_primitives(gamma);
    find_faces(dt_over_spacing, gamma);
    find_fluxes(gamma);
    update(dt_over_spacing);
}

void Pencil::fill_ghosts(Boundary boundary) {
    for (int variable = 0; variable < variables; ++variable) {
        float* row = conserved(variable);
        const float mirrored = variable == 1 ? -1.0F : 1.0F;
        for (int g = 1; g <= ghosts; ++g) {
            switch (boundary) {
            case Boundary::outflow:
                row[-g] = row[0];
                row[cells_ - 1 + g] = row[cells_ - 1];
                break;
            case Boundary::wall:
                row[-g] = mirrored * row[g - 1];
                row[cells_ - 1 + g] = mirrored * row[cells_ - g];
                break;
            case Boundary::periodic:
                row[-g] = row[cells_ - g];
                row[cells_ - 1 + g] = row[g - 1];
                break;
            }
        }
    }
}

// "ivdep" from here on: the rows of a pencil never overlap, which the compiler cannot see.

void Pencil::find_primitives(float gamma) {
    const int end = cells_ + 2 * ghosts;
    const float* mass = conserved_[0].data();
    const float* m1 = conserved_[1].data();
    const float* m2 = conserved_[2].data();
    const float* m3 = conserved_[3].data();
    const float* energy = conserved_[4].data();
    float* density = primitive_[0].data();
    float* u = primitive_[1].data();
    float* v = primitive_[2].data();
    float* w = primitive_[3].data();
    float* pressure = primitive_[4].data();
#pragma GCC ivdep
    for (int i = 0; i < end; ++i) {
        const float volume = 1.0F / mass[i];
        const float kinetic = 0.5F * volume * (m1[i] * m1[i] + m2[i] * m2[i] + m3[i] * m3[i]);
        density[i] = mass[i];
        u[i] = volume * m1[i];
        v[i] = volume * m2[i];
        w[i] = volume * m3[i];
        pressure[i] = (gamma - 1.0F) * std::max(energy[i] - kinetic, smallest_pressure_to_kinetic * kinetic);
    }
    for (int t = 5; t < variables; ++t) {
        const float* partial = conserved_[t].data();
        float* fraction = primitive_[t].data();
#pragma GCC ivdep
        for (int i = 0; i < end; ++i) {
            fraction[i] = partial[i] / mass[i];
        }
    }
}

/// Slopes in the cells, then half a step in time, so that the states at the faces are second order in space and time.
void Pencil::find_faces(float dt_over_spacing, float gamma) {
    const int end = cells_ + 2 * ghosts - 1;
    const float half = 0.5F * dt_over_spacing;
    const float* density = primitive_[0].data();
    const float* u = primitive_[1].data();
    const float* pressure = primitive_[4].data();
    float* density_low = low_[0].data();
    float* density_high = high_[0].data();
    float* u_low = low_[1].data();
    float* u_high = high_[1].data();
    float* pressure_low = low_[4].data();
    float* pressure_high = high_[4].data();
#pragma GCC ivdep
    for (int i = 1; i < end; ++i) {
        const float d_density = limited_slope(density[i - 1], density[i], density[i + 1]);
        const float d_u = limited_slope(u[i - 1], u[i], u[i + 1]);
        const float d_pressure = limited_slope(pressure[i - 1], pressure[i], pressure[i + 1]);
        const float density_half = density[i] - half * (u[i] * d_density + density[i] * d_u);
        const float u_half = u[i] - half * (u[i] * d_u + d_pressure / density[i]);
        const float pressure_half = pressure[i] - half * (u[i] * d_pressure + gamma * pressure[i] * d_u);
        const float least_density = density_half - 0.5F * std::fabs(d_density);
        const float least_pressure = pressure_half - 0.5F * std::fabs(d_pressure);
        const bool positive = (least_density > smallest_fraction_at_face * density[i]) &
                              (least_pressure > smallest_fraction_at_face * pressure[i]);
        density_low[i] = positive ? density_half - 0.5F * d_density : density[i];
        density_high[i] = positive ? density_half + 0.5F * d_density : density[i];
        u_low[i] = positive ? u_half - 0.5F * d_u : u[i];
        u_high[i] = positive ? u_half + 0.5F * d_u : u[i];
        pressure_low[i] = positive ? pressure_half - 0.5F * d_pressure : pressure[i];
        pressure_high[i] = positive ? pressure_half + 0.5F * d_pressure : pressure[i];
    }
    for (const int variable : carried) {
        const float* value = primitive_[variable].data();
        float* low = low_[variable].data();
        float* high = high_[variable].data();
#pragma GCC ivdep
        for (int i = 1; i < end; ++i) {
            const float slope = limited_slope(value[i - 1], value[i], value[i + 1]);
            const float value_half = value[i] - half * u[i] * slope;
            low[i] = value_half - 0.5F * slope;
            high[i] = value_half + 0.5F * slope;
        }
    }
}

void Pencil::find_fluxes(float gamma) {
    const int begin = ghosts;
    const int end = cells_ + ghosts + 1;
    std::array<const float*, variables> left{};
    std::array<const float*, variables> right{};
    for (int variable = 0; variable < variables; ++variable) {
        left[variable] = high_[variable].data() - 1;
        right[variable] = low_[variable].data();
    }
    float* mass = flux_[0].data();
    float* momentum = flux_[1].data();
    float* energy = flux_[4].data();
#pragma GCC ivdep
    for (int i = begin; i < end; ++i) {
        const Side l = make_side(left[0][i], left[1][i], left[2][i], left[3][i], left[4][i], gamma);
        const Side r = make_side(right[0][i], right[1][i], right[2][i], right[3][i], right[4][i], gamma);
        const Flux flux = hllc(l, r);
        mass[i] = flux.mass;
        momentum[i] = flux.momentum;
        energy[i] = flux.energy;
    }
    for (const int variable : carried) {
        const float* from_left = left[variable];
        const float* from_right = right[variable];
        float* flux = flux_[variable].data();
#pragma GCC ivdep
        for (int i = begin; i < end; ++i) {
            flux[i] = mass[i] * (mass[i] >= 0.0F ? from_left[i] : from_right[i]);
        }
    }
}

void Pencil::update(float dt_over_spacing) {
    for (int variable = 0; variable < variables; ++variable) {
        float* value = conserved_[variable].data();
        const float* flux = flux_[variable].data();
#pragma GCC ivdep
        for (int i = ghosts; i < cells_ + ghosts; ++i) {
            value[i] += dt_over_spacing * (flux[i] - flux[i + 1]);
        }
    }
}

} // namespace euler
