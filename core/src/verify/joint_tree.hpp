#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "verify/fragments.hpp"
#include "verify/joint_distance.hpp"
#include "verify/joint_surface.hpp"

namespace meshbound::verification {

/// The nearest point of a surface, by its distance or, on a surface with multipliers, by distance / multiplier.
struct Foot {
    Nearest nearest{JointDistance::infinite, 0, 0};
    std::uint32_t triangle = 0;
};

/// A tree of boxes in the joint space over the triangles of a surface, long thin ones in fragments: boxes are around these,
/// distances are to the whole triangle. The surface has a triangle, and must outlive it.
class JointTree {
public:
    JointTree(const JointSurface& surface, const JointSpace& space);

    /// The point of the surface nearest to `q`; the first one found that is no farther than `enough` ends the search.
    /// `guess` is a triangle to look at first. Where the surface has multipliers, every point's distance counts divided by the
    /// multiplier there.
    Foot nearest(const double* q, double enough, std::uint32_t guess) const;

    /// How many distances to triangles were worked out so far: what a search costs.
    std::size_t distances_found() const { return distances_found_; }

private:
    /// An inner node has its children at `first` and `first + 1`; a leaf its fragments at fragments_[first … first + count].
    struct Node {
        std::uint32_t first;
        std::uint32_t count; ///< 0 for an inner node
    };
    struct Pending {
        double distance;
        std::uint32_t node;
    };

    void enclose(std::uint32_t node, std::uint32_t begin, std::uint32_t end);
    void split(std::uint32_t node, std::uint32_t begin, std::uint32_t end);
    int widest(std::uint32_t node) const;
    double middle(const Fragment& fragment, int dimension) const;
    double box_distance(const double* q, std::uint32_t node) const;
    double most_multiplier(std::uint32_t begin, std::uint32_t end) const;
    Nearest multiplied(const double* q, std::uint32_t triangle, double enough, double cutoff) const;
    void try_triangle(const double* q, double enough, std::uint32_t triangle, Foot& foot) const;

    const JointSurface& surface_;
    std::vector<int> components_;
    JointDistance metric_;
    std::vector<Fragment> fragments_; ///< leaf after leaf
    std::vector<Node> nodes_;
    std::vector<double> boxes_;            ///< a node's lowest, then its highest corner
    std::vector<double> most_multipliers_; ///< by node; empty where the surface has none
    std::vector<double> origin_;
    mutable std::array<std::vector<double>, 3> scaled_;
    mutable std::vector<Pending> pending_;
    mutable std::size_t distances_found_ = 0;
    mutable std::vector<std::uint32_t> looked_at_; ///< by triangle: the search that has looked at it last
    mutable std::uint32_t search_ = 0;
};

} // namespace meshbound::verification
