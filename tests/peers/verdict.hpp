#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "judge/joint_distance.hpp"
#include "judge/joint_surface.hpp"
#include "judge/joint_tree.hpp"
#include "judge/sampling.hpp"
#include "meshbound/mesh.hpp"

namespace peers {

/// The judge is exact to this fraction of a bound; so a ratio up to 1 + hair passes.
inline constexpr double hair = 1e-6;

/// The judge's answer to "within the bounds?" alone, many times over for one original: the same samples, trees and
/// distances as judge::judge, but a sample's search ends with the first point within 1, the first sample without one
/// ends the verdict, and a whole triangle of the original passes where its corners lie within 1 of one triangle of the
/// other surface (the distance from a convex set is a convex function).
class Verdict {
public:
    /// `bounds`: absolute, of position first, then one a variable; as judge::judge takes them.
    Verdict(const meshbound::Mesh& original, const std::vector<double>& bounds);

    /// Nothing where judge::judge would give a ratio of at most 1 + hair; else the variable (0 is position, i + 1 the
    /// mesh's variable i) that is farthest at the first sample beyond. 0 for a surface without triangles or not finite.
    std::optional<std::size_t> beyond(const meshbound::Mesh& reduced);

private:
    using Answer = std::optional<std::size_t>;
    Answer hard_samples_beyond(const judge::JointSurface& reduced, const judge::JointTree& reduced_tree);
    Answer samples_beyond(const judge::JointSurface& reduced, const judge::JointTree& reduced_tree);
    Answer sample_beyond(const judge::JointSurface& from, const judge::Sample& sample, const judge::JointSurface& to,
                         const judge::JointTree& to_tree);
    bool triangle_within(std::uint32_t triangle, const judge::JointSurface& reduced,
                         const judge::JointTree& reduced_tree);
    bool corner_within(std::uint32_t vertex, const judge::JointSurface& reduced, std::uint32_t triangle) const;
    void remember(std::size_t sample);

    judge::JointSpace space;
    judge::JointSurface original;
    judge::JointTree tree;
    judge::JointDistance metric;
    std::vector<judge::Sample> samples;
    std::vector<std::size_t> hard; ///< samples that failed lately, the latest first: looked at before all others
    std::vector<std::uint32_t>
        feet; ///< for each vertex of the original, a triangle of the reduced surface near it, once found
    std::vector<double> point, foot_point;
    std::uint32_t guess = 0; ///< the triangle found last: neighbouring samples mostly end on the same one
};

} // namespace peers
