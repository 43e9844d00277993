#include "judge/joint_distance.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace judge {
namespace {

/// How far each step of the interior-point method aims towards the optimum: the gap left, as a fraction.
constexpr double centring = 0.1;
/// A step goes this far towards the nearest wall, never onto it.
constexpr double wall_distance = 0.99;
/// How far the start is moved from the least-squares place towards the centre of the triangle.
constexpr double start_inside = 0.02;
/// How far above the largest quadratic its level stands.
constexpr double start_height = 1.5;
/// Steps of the interior-point method; some ten are usual.
constexpr int most_steps = 60;
/// Moves of the expansion to the place found, needed where the triangle is huge beside the bounds.
constexpr int most_expansions = 4;
/// The determinant of a quadratic, relative to its largest, from which its lowest place needs no second thought.
constexpr double well_conditioned = 1e-3;
/// A few units in the last place of a double: the relative error of a sum of some ten products.
constexpr double rounding_unit = 2e-15;

} // namespace

JointDistance::JointDistance(std::vector<int> components_)
    : components(std::move(components_)), quadratics(components.size()), weights(components.size()),
      weight_steps(components.size()), slacks(components.size()), slack_steps(components.size()) {
    for (int n : components) dimensions += n;
    point.resize(static_cast<std::size_t>(dimensions));
}

double JointDistance::between(const double* p, const double* q, std::size_t* dominant) const {
    double worst = 0;
    if (dominant) *dominant = 0;
    for (std::size_t g = 0; g < components.size(); ++g) {
        double sum = 0;
        for (int i = 0; i < components[g]; ++i, ++p, ++q) sum += (*p - *q) * (*p - *q);
        if (sum <= worst) continue;
        worst = sum;
        if (dominant) *dominant = g;
    }
    return std::sqrt(worst);
}

double JointDistance::Quadratic::rounding(Offset p) const {
    return rounding_unit * (A * p.u * p.u + C * p.v * p.v + F);
}

void JointDistance::expand(const Triangle& t) const {
    int i = 0;
    for (std::size_t g = 0; g < components.size(); ++g) {
        Quadratic sum;
        for (const int end = i + components[g]; i < end; ++i) {
            const double along_u = t.b[i] - t.a[i];
            const double along_v = t.c[i] - t.a[i];
            const double rest = t.a[i] - t.q[i] + base.u * along_u + base.v * along_v;
            sum.A += along_u * along_u;
            sum.B += along_u * along_v;
            sum.C += along_v * along_v;
            sum.D += along_u * rest;
            sum.E += along_v * rest;
            sum.F += rest * rest;
        }
        quadratics[g] = sum;
    }
}

double JointDistance::largest(Offset place) const {
    double worst = 0;
    for (const Quadratic& h : quadratics) worst = std::max(worst, h.at(place));
    return worst;
}

/// Distances from the edges u = 0, v = 0, u + v = 1, in (u, v).
std::array<double, 3> JointDistance::edge_distances(Offset place) const {
    const double u = base.u + place.u;
    const double v = base.v + place.v;
    return {u, v, 1 - u - v};
}

/// Where one convex quadratic is lowest on the triangle: inside if its own lowest place lies there, else on an edge. A
/// quadratic that is level in some direction has many such places; the one near the base suffers least from rounding.
JointDistance::Offset JointDistance::lowest(const Quadratic& h) const {
    const auto is_inside = [this](Offset place) {
        const auto distances = edge_distances(place);
        return distances[0] >= 0 && distances[1] >= 0 && distances[2] >= 0;
    };
    const double determinant = h.A * h.C - h.B * h.B;
    const Offset inside{(h.B * h.E - h.C * h.D) / determinant, (h.B * h.D - h.A * h.E) / determinant};
    if (determinant > well_conditioned * h.A * h.C && is_inside(inside)) return inside;

    Offset best{0, 0};
    const auto consider = [&](Offset place) {
        if (h.at(place) + h.rounding(place) < h.at(best)) best = place;
    };
    if (const Offset along_u{-h.D / h.A, 0}; h.A > 0 && is_inside(along_u)) consider(along_u);
    if (const Offset along_v{0, -h.E / h.C}; h.C > 0 && is_inside(along_v)) consider(along_v);
    if (determinant > 0 && is_inside(inside)) consider(inside);
    const auto lowest_between = [](double square, double slope, double low, double high) {
        return square > 0 ? std::clamp(-slope / square, low, high) : slope > 0 ? low : high;
    };
    const double rest = 1 - base.u - base.v;
    consider({-base.u, lowest_between(h.C, h.E - h.B * base.u, -base.v, 1 - base.v)});
    consider({lowest_between(h.A, h.D - h.B * base.v, -base.u, 1 - base.u), -base.v});
    const double on_w = lowest_between(h.A - 2 * h.B + h.C, (h.B - h.C) * rest + h.D - h.E, -base.u, 1 - base.u);
    consider({on_w, rest - on_w});
    return best;
}

/// Improves both bounds with the least-squares problem of the current weights.
void JointDistance::bracket(Certified& best) const {
    const double whole = std::accumulate(weights.begin(), weights.end(), 0.0);
    Quadratic sum;
    for (std::size_t g = 0; g < quadratics.size(); ++g) {
        const Quadratic& h = quadratics[g];
        const double share = weights[g] / whole;
        sum.A += share * h.A;
        sum.B += share * h.B;
        sum.C += share * h.C;
        sum.D += share * h.D;
        sum.E += share * h.E;
        sum.F += share * h.F;
    }
    const Offset place = lowest(sum);
    best.lower = std::max(best.lower, sum.at(place) - sum.rounding(place));
    const double upper = largest(place);
    if (upper < best.upper) best = {place, upper, best.lower};
}

bool JointDistance::decided(const Certified& best) const {
    if (best.upper <= enough_squared || best.lower > cutoff_squared) return true;
    const double upper = std::sqrt(best.upper);
    return upper - std::sqrt(std::max(0.0, best.lower)) <= accuracy * std::max(1.0, upper);
}

/// A strictly inner place with slacks and multipliers that balance each other.
void JointDistance::start(Offset place) const {
    const Offset centre{1.0 / 3 - base.u, 1.0 / 3 - base.v};
    iterate.place = {place.u + start_inside * (centre.u - place.u), place.v + start_inside * (centre.v - place.v)};
    iterate.level = start_height * largest(iterate.place);
    double sum = 0;
    for (std::size_t g = 0; g < quadratics.size(); ++g) {
        slacks[g] = iterate.level - quadratics[g].at(iterate.place);
        sum += 1 / slacks[g];
    }
    for (std::size_t g = 0; g < quadratics.size(); ++g) weights[g] = 1 / (sum * slacks[g]);
    const auto distances = edge_distances(iterate.place);
    for (int i = 0; i < 3; ++i) iterate.edges[i] = 1 / (sum * distances[i]);
}

/// The product that slacks and multipliers shall come to: a fraction of what they are now, in the mean.
double JointDistance::barrier() const {
    const auto distances = edge_distances(iterate.place);
    double gap = 0;
    for (std::size_t g = 0; g < quadratics.size(); ++g) gap += weights[g] * slacks[g];
    for (int i = 0; i < 3; ++i) gap += iterate.edges[i] * distances[i];
    return centring * gap / static_cast<double>(quadratics.size() + 3);
}

/// The Newton step of place and level, the multipliers eliminated. False where rounding leaves no direction.
bool JointDistance::newton(double product, Offset& step, double& rise) const {
    double uu = 0, uv = 0, vv = 0, right_u = 0, right_v = 0;   // the system in (u, v)
    double stiffness = 0, pull_u = 0, pull_v = 0, excess = -1; // its coupling to the level
    for (std::size_t g = 0; g < quadratics.size(); ++g) {
        const Quadratic& h = quadratics[g];
        const Offset slope = h.slope(iterate.place);
        const double stiff = weights[g] / slacks[g];
        const double push = product / slacks[g] + stiff * (slacks[g] + h.at(iterate.place) - iterate.level);
        uu += 2 * weights[g] * h.A + stiff * slope.u * slope.u;
        uv += 2 * weights[g] * h.B + stiff * slope.u * slope.v;
        vv += 2 * weights[g] * h.C + stiff * slope.v * slope.v;
        right_u -= push * slope.u;
        right_v -= push * slope.v;
        stiffness += stiff;
        pull_u += stiff * slope.u;
        pull_v += stiff * slope.v;
        excess += push;
    }
    const auto distances = edge_distances(iterate.place);
    for (int i = 0; i < 3; ++i) {
        const double stiff = iterate.edges[i] / distances[i];
        uu += stiff * inward[i].u * inward[i].u;
        uv += stiff * inward[i].u * inward[i].v;
        vv += stiff * inward[i].v * inward[i].v;
        right_u += product / distances[i] * inward[i].u;
        right_v += product / distances[i] * inward[i].v;
    }
    uu -= pull_u * pull_u / stiffness;
    uv -= pull_u * pull_v / stiffness;
    vv -= pull_v * pull_v / stiffness;
    right_u += pull_u * excess / stiffness;
    right_v += pull_v * excess / stiffness;
    const double determinant = uu * vv - uv * uv;
    step = {(vv * right_u - uv * right_v) / determinant, (uu * right_v - uv * right_u) / determinant};
    rise = (excess + pull_u * step.u + pull_v * step.v) / stiffness;
    return determinant > 0;
}

/// One step of the primal-dual method for: the lowest level with quadratic + slack = level, slack >= 0, inside the
/// triangle. False where it stalls.
bool JointDistance::advance() const {
    const double product = barrier();
    Offset step{};
    double rise = 0;
    if (!newton(product, step, rise)) return false;
    double length = 1;
    const auto keep_positive = [&length](double value, double change) {
        if (change < 0) length = std::min(length, -wall_distance * value / change);
    };
    for (std::size_t g = 0; g < quadratics.size(); ++g) {
        const Offset slope = quadratics[g].slope(iterate.place);
        slack_steps[g] =
            iterate.level + rise - slacks[g] - quadratics[g].at(iterate.place) - slope.u * step.u - slope.v * step.v;
        weight_steps[g] = (product - weights[g] * slack_steps[g]) / slacks[g] - weights[g];
        keep_positive(slacks[g], slack_steps[g]);
        keep_positive(weights[g], weight_steps[g]);
    }
    const auto distances = edge_distances(iterate.place);
    std::array<double, 3> edge_steps{};
    for (int i = 0; i < 3; ++i) {
        const double approach = inward[i].u * step.u + inward[i].v * step.v;
        edge_steps[i] = (product - iterate.edges[i] * approach) / distances[i] - iterate.edges[i];
        keep_positive(distances[i], approach);
        keep_positive(iterate.edges[i], edge_steps[i]);
    }
    if (!(length > rounding_unit)) return false;
    iterate.place = {iterate.place.u + length * step.u, iterate.place.v + length * step.v};
    iterate.level += length * rise;
    for (std::size_t g = 0; g < weights.size(); ++g) {
        slacks[g] += length * slack_steps[g];
        weights[g] += length * weight_steps[g];
    }
    for (int i = 0; i < 3; ++i) iterate.edges[i] += length * edge_steps[i];
    return true;
}

JointDistance::Certified JointDistance::minimax() const {
    Certified best{{}, infinite, 0};
    std::fill(weights.begin(), weights.end(), 1.0 / static_cast<double>(weights.size()));
    bracket(best);
    if (decided(best)) return best;
    start(best.place);
    for (int i = 0; i < most_steps && advance(); ++i) {
        const double upper = largest(iterate.place);
        if (upper < best.upper) best = {iterate.place, upper, best.lower};
        bracket(best);
        if (decided(best)) break;
    }
    return best;
}

double JointDistance::attained(const Triangle& t, double u, double v) const {
    for (int i = 0; i < dimensions; ++i) point[i] = t.a[i] + u * (t.b[i] - t.a[i]) + v * (t.c[i] - t.a[i]);
    return between(t.q, point.data());
}

Nearest JointDistance::to_triangle(const double* q, const double* a, const double* b, const double* c, double enough,
                                   double cutoff) const {
    const Triangle triangle{q, a, b, c};
    enough_squared = enough * enough;
    cutoff_squared = cutoff * cutoff;
    base = {1.0 / 3, 1.0 / 3};
    Nearest nearest{infinite, base.u, base.v};
    for (int i = 0; i < most_expansions; ++i) {
        expand(triangle);
        const Certified found = minimax();
        if (found.lower > cutoff_squared) return {infinite, base.u, base.v};
        double rounding = 0;
        for (const Quadratic& h : quadratics) rounding = std::max(rounding, h.rounding(found.place));
        base.u = std::clamp(base.u + found.place.u, 0.0, 1.0);
        base.v = std::clamp(base.v + found.place.v, 0.0, 1.0 - base.u);
        const double distance = attained(triangle, base.u, base.v);
        if (distance < nearest.distance) nearest = {distance, base.u, base.v};
        if (nearest.distance <= enough || rounding <= accuracy * std::max(accuracy, distance * distance)) break;
    }
    return nearest;
}

} // namespace judge
