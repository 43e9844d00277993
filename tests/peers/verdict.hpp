#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "meshbound/mesh.hpp"
#include "meshbound/verify.hpp"
#include "verify/joint_distance.hpp"
#include "verify/joint_surface.hpp"
#include "verify/joint_tree.hpp"
#include "verify/sampling.hpp"

namespace peers {

namespace verification = meshbound::verification;

/// The judge is exact to this fraction of a bound; so a ratio up to 1 + hair passes.
inline constexpr double hair = meshbound::verify_accuracy;

/// The judge's answer to "within the bounds?" alone, many times over for one original: the same samples, trees and
/// distances as meshbound::verify, but a sample's search ends with the first point within 1, the first sample without one
/// ends the verdict, and a whole triangle of the original passes where its corners lie within 1 of one triangle of the
/// other surface (the distance from a convex set is a convex function).
class Verdict {
public:
    /// `bounds`: absolute, of position first, then one a variable; as meshbound::verify takes them.
    Verdict(const meshbound::Mesh& original, const std::vector<double>& bounds);

    /// Nothing where meshbound::verify would give the surfaces a ratio of at most 1 + hair; else the variable (0 is position, i + 1 the
    /// mesh's variable i) that is farthest at the first sample beyond. 0 for a surface without triangles or not finite.
    std::optional<std::size_t> beyond(const meshbound::Mesh& reduced);

private:
    using Answer = std::optional<std::size_t>;
    Answer hard_samples_beyond(const verification::JointSurface& reduced, const verification::JointTree& reduced_tree);
    Answer samples_beyond(const verification::JointSurface& reduced, const verification::JointTree& reduced_tree);
    Answer sample_beyond(const verification::JointSurface& from, const verification::Sample& sample,
                         const verification::JointSurface& to, const verification::JointTree& to_tree);
    bool triangle_within(std::uint32_t triangle, const verification::JointSurface& reduced,
                         const verification::JointTree& reduced_tree);
    bool corner_within(std::uint32_t vertex, const verification::JointSurface& reduced, std::uint32_t triangle) const;
    void remember(std::size_t sample);

    verification::JointSpace space;
    verification::JointSurface original;
    verification::JointTree tree;
    verification::JointDistance metric;
    std::vector<verification::Sample> samples;
    std::vector<std::size_t> hard; ///< samples that failed lately, the latest first: looked at before all others
    std::vector<std::uint32_t>
        feet; ///< for each vertex of the original, a triangle of the reduced surface near it, once found
    std::vector<double> point, foot_point;
    std::uint32_t guess = 0; ///< the triangle found last: neighbouring samples mostly end on the same one
};

} // namespace peers
