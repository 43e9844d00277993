#include "verify/joint_distance.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace meshbound::verification {
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
/// Halvings of a segment: then rounding is coarser.
constexpr int most_halvings = 60;
/// A few units in the last place of a double: the relative error of a sum of some ten products.
constexpr double rounding_unit = 2e-15;

double squared_length(const double* p, const double* q, int components) {
    double sum = 0;
    for (int i = 0; i < components; ++i) sum += (p[i] - q[i]) * (p[i] - q[i]);
    return sum;
}

} // namespace

JointDistance::JointDistance(std::vector<int> components)
    : components_(std::move(components)), quadratics_(components_.size()), weights_(components_.size()),
      weight_steps_(components_.size()), slacks_(components_.size()), slack_steps_(components_.size()) {
    for (int n : components_) dimensions_ += n;
    point_.resize(static_cast<std::size_t>(dimensions_));
}

double JointDistance::between(const double* p, const double* q) const {
    double worst = 0;
    for (const int n : components_) {
        worst = std::max(worst, squared_length(p, q, n));
        p += n;
        q += n;
    }
    return std::sqrt(worst);
}

std::size_t JointDistance::farthest_variable(const double* p, const double* q) const {
    double worst = 0;
    std::size_t farthest = 0;
    for (std::size_t g = 0; g < components_.size(); ++g) {
        if (const double square = squared_length(p, q, components_[g]); square > worst) {
            worst = square;
            farthest = g;
        }
        p += components_[g];
        q += components_[g];
    }
    return farthest;
}

double JointDistance::Quadratic::rounding(Offset p) const {
    return rounding_unit * (A * p.u * p.u + C * p.v * p.v + F);
}

void JointDistance::expand(const Triangle& t) const {
    int i = 0;
    for (std::size_t g = 0; g < components_.size(); ++g) {
        Quadratic sum;
        for (const int end = i + components_[g]; i < end; ++i) {
            const double along_u = t.b[i] - t.a[i];
            const double along_v = t.c[i] - t.a[i];
            const double rest = t.a[i] - t.q[i] + base_.u * along_u + base_.v * along_v;
            sum.A += along_u * along_u;
            sum.B += along_u * along_v;
            sum.C += along_v * along_v;
            sum.D += along_u * rest;
            sum.E += along_v * rest;
            sum.F += rest * rest;
        }
        quadratics_[g] = sum;
    }
}

double JointDistance::largest(Offset place) const {
    double worst = 0;
    for (const Quadratic& h : quadratics_) worst = std::max(worst, h.at(place));
    return worst;
}

/// Distances from the edges u = 0, v = 0, u + v = 1, in (u, v).
std::array<double, 3> JointDistance::edge_distances(Offset place) const {
    const double u = base_.u + place.u;
    const double v = base_.v + place.v;
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
    const double rest = 1 - base_.u - base_.v;
    consider({-base_.u, lowest_between(h.C, h.E - h.B * base_.u, -base_.v, 1 - base_.v)});
    consider({lowest_between(h.A, h.D - h.B * base_.v, -base_.u, 1 - base_.u), -base_.v});
    const double on_w = lowest_between(h.A - 2 * h.B + h.C, (h.B - h.C) * rest + h.D - h.E, -base_.u, 1 - base_.u);
    consider({on_w, rest - on_w});
    return best;
}

/// Improves both bounds with the least-squares problem of the current weights.
void JointDistance::bracket(Certified& best) const {
    const double whole = std::accumulate(weights_.begin(), weights_.end(), 0.0);
    Quadratic sum;
    for (std::size_t g = 0; g < quadratics_.size(); ++g) {
        const Quadratic& h = quadratics_[g];
        const double share = weights_[g] / whole;
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
    if (best.upper <= enough_squared_ || best.lower > cutoff_squared_) return true;
    const double upper = std::sqrt(best.upper);
    return upper - std::sqrt(std::max(0.0, best.lower)) <= accuracy * std::max(1.0, upper);
}

/// A strictly inner place with slacks and multipliers that balance each other.
void JointDistance::start(Offset place) const {
    const Offset centre{1.0 / 3 - base_.u, 1.0 / 3 - base_.v};
    iterate_.place = {place.u + start_inside * (centre.u - place.u), place.v + start_inside * (centre.v - place.v)};
    iterate_.level = start_height * largest(iterate_.place);
    double sum = 0;
    for (std::size_t g = 0; g < quadratics_.size(); ++g) {
        slacks_[g] = iterate_.level - quadratics_[g].at(iterate_.place);
        sum += 1 / slacks_[g];
    }
    for (std::size_t g = 0; g < quadratics_.size(); ++g) weights_[g] = 1 / (sum * slacks_[g]);
    const auto distances = edge_distances(iterate_.place);
    for (int i = 0; i < 3; ++i) iterate_.edges[i] = 1 / (sum * distances[i]);
}

/// The product that slacks and multipliers shall come to: a fraction of what they are now, in the mean.
double JointDistance::barrier() const {
    const auto distances = edge_distances(iterate_.place);
    double gap = 0;
    for (std::size_t g = 0; g < quadratics_.size(); ++g) gap += weights_[g] * slacks_[g];
    for (int i = 0; i < 3; ++i) gap += iterate_.edges[i] * distances[i];
    return centring * gap / static_cast<double>(quadratics_.size() + 3);
}

/// The Newton step of place and level, the multipliers eliminated. False where rounding leaves no direction.
bool JointDistance::newton(double product, Offset& step, double& rise) const {
    double uu = 0, uv = 0, vv = 0, right_u = 0, right_v = 0;   // the system in (u, v)
    double stiffness = 0, pull_u = 0, pull_v = 0, excess = -1; // its coupling to the level
    for (std::size_t g = 0; g < quadratics_.size(); ++g) {
        const Quadratic& h = quadratics_[g];
        const Offset slope = h.slope(iterate_.place);
        const double stiff = weights_[g] / slacks_[g];
        const double push = product / slacks_[g] + stiff * (slacks_[g] + h.at(iterate_.place) - iterate_.level);
        uu += 2 * weights_[g] * h.A + stiff * slope.u * slope.u;
        uv += 2 * weights_[g] * h.B + stiff * slope.u * slope.v;
        vv += 2 * weights_[g] * h.C + stiff * slope.v * slope.v;
        right_u -= push * slope.u;
        right_v -= push * slope.v;
        stiffness += stiff;
        pull_u += stiff * slope.u;
        pull_v += stiff * slope.v;
        excess += push;
    }
    const auto distances = edge_distances(iterate_.place);
    for (int i = 0; i < 3; ++i) {
        const double stiff = iterate_.edges[i] / distances[i];
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
    for (std::size_t g = 0; g < quadratics_.size(); ++g) {
        const Offset slope = quadratics_[g].slope(iterate_.place);
        slack_steps_[g] = iterate_.level + rise - slacks_[g] - quadratics_[g].at(iterate_.place) - slope.u * step.u -
                          slope.v * step.v;
        weight_steps_[g] = (product - weights_[g] * slack_steps_[g]) / slacks_[g] - weights_[g];
        keep_positive(slacks_[g], slack_steps_[g]);
        keep_positive(weights_[g], weight_steps_[g]);
    }
    const auto distances = edge_distances(iterate_.place);
    std::array<double, 3> edge_steps{};
    for (int i = 0; i < 3; ++i) {
        const double approach = inward[i].u * step.u + inward[i].v * step.v;
        edge_steps[i] = (product - iterate_.edges[i] * approach) / distances[i] - iterate_.edges[i];
        keep_positive(distances[i], approach);
        keep_positive(iterate_.edges[i], edge_steps[i]);
    }
    if (!(length > rounding_unit)) return false;
    iterate_.place = {iterate_.place.u + length * step.u, iterate_.place.v + length * step.v};
    iterate_.level += length * rise;
    for (std::size_t g = 0; g < weights_.size(); ++g) {
        slacks_[g] += length * slack_steps_[g];
        weights_[g] += length * weight_steps_[g];
    }
    for (int i = 0; i < 3; ++i) iterate_.edges[i] += length * edge_steps[i];
    return true;
}

JointDistance::Certified JointDistance::minimax() const {
    Certified best{{}, infinite, 0};
    std::fill(weights_.begin(), weights_.end(), 1.0 / static_cast<double>(weights_.size()));
    bracket(best);
    if (decided(best)) return best;
    start(best.place);
    for (int i = 0; i < most_steps && advance(); ++i) {
        const double upper = largest(iterate_.place);
        if (upper < best.upper) best = {iterate_.place, upper, best.lower};
        bracket(best);
        if (decided(best)) break;
    }
    return best;
}

double JointDistance::attained(const Triangle& t, double u, double v) const {
    for (int i = 0; i < dimensions_; ++i) point_[i] = t.a[i] + u * (t.b[i] - t.a[i]) + v * (t.c[i] - t.a[i]);
    return between(t.q, point_.data());
}

/// At u on the segment from a to b: the squared distance, and its slope, in the variable in which `q` is farthest.
JointDistance::Tangent JointDistance::tangent(const double* q, const double* a, const double* b, double u) const {
    Tangent worst{-1, 0};
    int i = 0;
    for (const int count : components_) {
        Tangent one{0, 0};
        for (const int end = i + count; i < end; ++i) {
            const double rest = a[i] + u * (b[i] - a[i]) - q[i];
            one.square += rest * rest;
            one.slope += 2 * rest * (b[i] - a[i]);
        }
        if (one.square > worst.square) worst = one;
    }
    return worst;
}

/// By halving: the largest of convex functions is convex, so its tangent tells on which side the lowest place lies, and how low
/// it can be there.
Nearest JointDistance::to_segment(const double* q, const double* a, const double* b) const {
    const Triangle segment{q, a, b, b};
    Nearest nearest{attained(segment, 0, 0), 0, 0};
    const auto consider = [&](double u) {
        if (const double distance = attained(segment, u, 0); distance < nearest.distance) nearest = {distance, u, 0};
    };
    consider(1);
    double low = 0, high = 1;
    for (int i = 0; i < most_halvings && nearest.distance * nearest.distance > enough_squared_; ++i) {
        const double middle = (low + high) / 2;
        const Tangent here = tangent(q, a, b, middle);
        if (here.square - std::abs(here.slope) * (high - middle) > cutoff_squared_) return {infinite, middle, 0};
        consider(middle);
        (here.slope > 0 ? high : low) = middle;
    }
    return nearest;
}

Nearest JointDistance::to_triangle(const double* q, const double* a, const double* b, const double* c, double enough,
                                   double cutoff) const {
    enough_squared_ = enough * enough;
    cutoff_squared_ = cutoff * cutoff;
    if (std::equal(b, b + dimensions_, c)) return to_segment(q, a, b);
    const Triangle triangle{q, a, b, c};
    base_ = {1.0 / 3, 1.0 / 3};
    Nearest nearest{infinite, base_.u, base_.v};
    for (int i = 0; i < most_expansions; ++i) {
        expand(triangle);
        const Certified found = minimax();
        if (found.lower > cutoff_squared_) return {infinite, base_.u, base_.v};
        double rounding = 0;
        for (const Quadratic& h : quadratics_) rounding = std::max(rounding, h.rounding(found.place));
        base_.u = std::clamp(base_.u + found.place.u, 0.0, 1.0);
        base_.v = std::clamp(base_.v + found.place.v, 0.0, 1.0 - base_.u);
        const double distance = attained(triangle, base_.u, base_.v);
        if (distance < nearest.distance) nearest = {distance, base_.u, base_.v};
        if (nearest.distance <= enough || rounding <= accuracy * std::max(accuracy, distance * distance)) break;
    }
    return nearest;
}

} // namespace meshbound::verification
