#include "verdict.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "judge/judge.hpp"

namespace peers {
namespace {

constexpr double limit = 1 + hair;
/// Where one result fails others fail as well; more places than these cost more than they save.
constexpr std::size_t most_hard_samples = 64;

std::vector<judge::Sample> samples_of(const judge::JointSurface& surface) {
    std::vector<judge::Sample> samples;
    judge::sample_surface(surface, judge::usual_samples, [&samples](const judge::Sample& s) { samples.push_back(s); });
    return samples;
}

bool is_finite(const judge::JointSurface& surface) {
    return std::all_of(surface.rows.begin(), surface.rows.end(), [](double value) { return std::isfinite(value); });
}

/// Whether the tree's surface has a point within the limit of a sample. `guess`: a triangle to look at first; then the
/// one found.
bool is_near(const judge::JointSurface& from, const judge::Sample& sample, const judge::JointTree& to,
             std::vector<double>& point, std::uint32_t& guess) {
    const auto& triangle = from.triangles[sample.triangle];
    for (std::size_t k = 0; k < point.size(); ++k) {
        point[k] = 0;
        for (int i = 0; i < 3; ++i) point[k] += sample.barycentric[i] * from.row(triangle[i])[k];
    }
    const judge::Foot foot = to.nearest(point.data(), limit, guess);
    guess = foot.triangle;
    return foot.nearest.distance <= limit;
}

} // namespace

Verdict::Verdict(const meshbound::Mesh& original_, const std::vector<double>& bounds)
    : space(judge::joint_space(original_, bounds)), original(judge::joint_surface(original_, space)),
      tree(original, space), samples(samples_of(original)), point(static_cast<std::size_t>(space.dimensions())) {}

bool Verdict::within(const meshbound::Mesh& mesh) {
    const judge::JointSurface reduced = judge::joint_surface(mesh, space);
    if (reduced.triangles.empty() || !is_finite(reduced)) return false;
    const judge::JointTree reduced_tree(reduced, space);
    if (!hard_samples_within(reduced_tree) || !samples_within(reduced_tree)) return false;
    std::uint32_t guess = 0;
    const std::vector<judge::Sample> others = samples_of(reduced);
    return std::all_of(others.begin(), others.end(),
                       [&](const judge::Sample& s) { return is_near(reduced, s, tree, point, guess); });
}

bool Verdict::hard_samples_within(const judge::JointTree& reduced) {
    std::uint32_t guess = 0;
    for (std::size_t i = 0; i < hard.size(); ++i)
        if (!is_near(original, samples[hard[i]], reduced, point, guess)) {
            std::rotate(hard.begin(), hard.begin() + static_cast<std::ptrdiff_t>(i),
                        hard.begin() + static_cast<std::ptrdiff_t>(i) + 1);
            return false;
        }
    return true;
}

bool Verdict::samples_within(const judge::JointTree& reduced) {
    std::uint32_t guess = 0;
    for (std::size_t s = 0; s < samples.size(); ++s)
        if (!is_near(original, samples[s], reduced, point, guess)) {
            remember(s);
            return false;
        }
    return true;
}

void Verdict::remember(std::size_t sample) {
    hard.insert(hard.begin(), sample);
    if (hard.size() > most_hard_samples) hard.pop_back();
}

} // namespace peers
