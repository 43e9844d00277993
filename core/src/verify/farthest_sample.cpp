#include "verify/farthest_sample.hpp"

#include <algorithm>
#include <array>

namespace meshbound::verification {
namespace {

/// A ratio below this is no deviation; so surfaces that coincide are not searched for the rounding between them.
constexpr double negligible = 1e-6;

/// What one sample takes, in units of the reporter: tens of microseconds.
constexpr std::size_t work_of_sample = 16;

void place(const JointSurface& surface, std::uint32_t triangle, const std::array<double, 3>& barycentric,
           std::vector<double>& point) {
    const auto& [a, b, c] = surface.triangles[triangle];
    for (std::size_t k = 0; k < point.size(); ++k)
        point[k] = barycentric[0] * surface.row(a)[k] + barycentric[1] * surface.row(b)[k] +
                   barycentric[2] * surface.row(c)[k];
}

/// 1 where nothing multiplies the bounds.
double multiplier_at(const JointSurface& surface, std::uint32_t triangle, const std::array<double, 3>& barycentric) {
    if (surface.multipliers.empty()) return 1;
    double sum = 0;
    for (std::size_t i = 0; i < 3; ++i) sum += barycentric[i] * surface.multipliers[surface.triangles[triangle][i]];
    return sum;
}

} // namespace

FarthestSample::FarthestSample(const JointSurface& from, const JointSurface& to, const JointSpace& space)
    : from_(from), to_(to), space_(space), tree_(to, space), metric_(space.components),
      point_(static_cast<std::size_t>(space.dimensions())), foot_point_(point_.size()) {}

const Deviation& FarthestSample::find(std::size_t samples, ShareOfWork share, ProgressReporter& reporter) {
    const double whole = static_cast<double>(from_.triangles.size());
    sample_surface(from_, samples, [&](const Sample& sample) {
        look_at(sample);
        return reporter.advance(work_of_sample, share.from + (share.to - share.from) * sample.triangle / whole);
    });
    return worst_;
}

/// A sample matters only if it is farther than the worst so far: the search ends with the first point within that.
void FarthestSample::look_at(const Sample& sample) {
    ++worst_.samples;
    place(from_, sample.triangle, sample.barycentric, point_);
    const double multiplier = multiplier_at(from_, sample.triangle, sample.barycentric);
    const double enough = multiplier * std::max(worst_.ratio, negligible);
    const Foot foot = tree_.nearest(point_.data(), enough, last_);
    last_ = foot.triangle;
    if (foot.nearest.distance <= enough) return;
    worst_.ratio = foot.nearest.distance / multiplier;
    worst_.triangle = sample.triangle;
    worst_.barycentric = sample.barycentric;
    worst_.variable = farthest_variable(foot);
}

/// The number of the variable in which the sample is farthest from what was found.
std::size_t FarthestSample::farthest_variable(const Foot& foot) {
    const auto [distance, u, v] = foot.nearest;
    place(to_, foot.triangle, {1 - u - v, u, v}, foot_point_);
    return space_.variables[metric_.farthest_variable(point_.data(), foot_point_.data())];
}

} // namespace meshbound::verification
