#include "verdict.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "meshbound/verify.hpp"

namespace peers {
namespace {

constexpr double limit = 1 + hair;
/// Where one result fails others fail as well; more places than these cost more than they save.
constexpr std::size_t most_hard_samples = 64;
constexpr auto unknown = std::numeric_limits<std::uint32_t>::max();

std::vector<verification::Sample> samples_of(const verification::JointSurface& surface) {
    std::vector<verification::Sample> samples;
    verification::sample_surface(surface, meshbound::VerifyOptions{}.samples,
                                 [&samples](const verification::Sample& s) {
                                     samples.push_back(s);
                                     return true;
                                 });
    return samples;
}

bool is_finite(const verification::JointSurface& surface) {
    return std::all_of(surface.rows.begin(), surface.rows.end(), [](double value) { return std::isfinite(value); });
}

void place(const verification::JointSurface& surface, std::uint32_t triangle, const std::array<double, 3>& barycentric,
           std::vector<double>& point) {
    for (std::size_t k = 0; k < point.size(); ++k) {
        point[k] = 0;
        for (std::size_t i = 0; i < 3; ++i) point[k] += barycentric[i] * surface.row(surface.triangles[triangle][i])[k];
    }
}

} // namespace

Verdict::Verdict(const meshbound::Mesh& original_, const std::vector<double>& bounds)
    : space(verification::joint_space(original_, bounds)), original(verification::joint_surface(original_, space)),
      tree(original, space), metric(space.components), samples(samples_of(original)),
      point(static_cast<std::size_t>(space.dimensions())), foot_point(point.size()) {}

std::optional<std::size_t> Verdict::beyond(const meshbound::Mesh& mesh) {
    const verification::JointSurface reduced = verification::joint_surface(mesh, space);
    if (reduced.triangles.empty() || !is_finite(reduced)) return 0;
    const verification::JointTree reduced_tree(reduced, space);
    guess = 0;
    if (const Answer answer = hard_samples_beyond(reduced, reduced_tree)) return answer;
    if (const Answer answer = samples_beyond(reduced, reduced_tree)) return answer;
    guess = 0;
    for (const verification::Sample& sample : samples_of(reduced))
        if (const Answer answer = sample_beyond(reduced, sample, original, tree)) return answer;
    return std::nullopt;
}

Verdict::Answer Verdict::hard_samples_beyond(const verification::JointSurface& reduced,
                                             const verification::JointTree& reduced_tree) {
    for (auto sample = hard.begin(); sample != hard.end(); ++sample)
        if (const Answer answer = sample_beyond(original, samples[*sample], reduced, reduced_tree)) {
            std::rotate(hard.begin(), sample, sample + 1);
            return answer;
        }
    return std::nullopt;
}

Verdict::Answer Verdict::samples_beyond(const verification::JointSurface& reduced,
                                        const verification::JointTree& reduced_tree) {
    feet.assign(original.rows.size() / static_cast<std::size_t>(space.dimensions()), unknown);
    std::uint32_t triangle = unknown;
    bool skipped = false;
    for (std::size_t s = 0; s < samples.size(); ++s) { // all those of a triangle follow each other
        if (samples[s].triangle != triangle) skipped = triangle_within(samples[s].triangle, reduced, reduced_tree);
        triangle = samples[s].triangle;
        if (skipped) continue;
        if (const Answer answer = sample_beyond(original, samples[s], reduced, reduced_tree)) {
            remember(s);
            return answer;
        }
    }
    return std::nullopt;
}

bool Verdict::triangle_within(std::uint32_t triangle, const verification::JointSurface& reduced,
                              const verification::JointTree& reduced_tree) {
    const auto& corners = original.triangles[triangle];
    for (std::uint32_t corner : corners) {
        if (feet[corner] == unknown) {
            const verification::Foot foot = reduced_tree.nearest(original.row(corner), limit, guess);
            guess = foot.triangle;
            if (foot.nearest.distance > limit) return false;
            feet[corner] = foot.triangle;
        }
        const auto near_foot = [&](std::uint32_t other) {
            return other == corner || corner_within(other, reduced, feet[corner]);
        };
        if (std::all_of(corners.begin(), corners.end(), near_foot)) return true;
    }
    return false;
}

bool Verdict::corner_within(std::uint32_t vertex, const verification::JointSurface& reduced,
                            std::uint32_t triangle) const {
    const auto& [a, b, c] = reduced.triangles[triangle];
    return metric.to_triangle(original.row(vertex), reduced.row(a), reduced.row(b), reduced.row(c), limit, limit)
               .distance <= limit;
}

Verdict::Answer Verdict::sample_beyond(const verification::JointSurface& from, const verification::Sample& sample,
                                       const verification::JointSurface& to, const verification::JointTree& to_tree) {
    place(from, sample.triangle, sample.barycentric, point);
    const verification::Foot foot = to_tree.nearest(point.data(), limit, guess);
    guess = foot.triangle;
    if (foot.nearest.distance <= limit) return std::nullopt;
    const auto [distance, u, v] = foot.nearest;
    place(to, foot.triangle, {1 - u - v, u, v}, foot_point);
    const std::size_t farthest = metric.farthest_variable(point.data(), foot_point.data());
    return space.variables[farthest];
}

void Verdict::remember(std::size_t sample) {
    hard.insert(hard.begin(), sample);
    if (hard.size() > most_hard_samples) hard.pop_back();
}

} // namespace peers
