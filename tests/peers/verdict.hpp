#pragma once

#include <cstddef>
#include <vector>

#include "judge/joint_surface.hpp"
#include "judge/joint_tree.hpp"
#include "judge/sampling.hpp"
#include "meshbound/mesh.hpp"

namespace peers {

/// The judge is exact to this fraction of a bound; so a ratio up to 1 + hair passes.
inline constexpr double hair = 1e-6;

/// The judge's answer to "within the bounds?" alone, many times over for one original: the same samples, trees and
/// distances as judge::judge, but a sample's search ends with the first point within 1, and the first sample without one
/// ends the verdict.
class Verdict {
public:
    /// `bounds`: absolute, of position first, then one a variable; as judge::judge takes them.
    Verdict(const meshbound::Mesh& original, const std::vector<double>& bounds);

    /// Whether judge::judge would give a ratio of at most 1 + hair. False for a surface without triangles or not finite.
    bool within(const meshbound::Mesh& reduced);

private:
    bool hard_samples_within(const judge::JointTree& tree);
    bool samples_within(const judge::JointTree& tree);
    void remember(std::size_t sample);

    judge::JointSpace space;
    judge::JointSurface original;
    judge::JointTree tree;
    std::vector<judge::Sample> samples;
    std::vector<std::size_t> hard; ///< samples that failed lately, the latest first: looked at before all others
    std::vector<double> point;
};

} // namespace peers
