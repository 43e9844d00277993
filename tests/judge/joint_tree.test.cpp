// The judge's search for the nearest point of a surface: exact on slivers, and not at the cost of looking at nearly all of them.

#include "verify/joint_tree.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <glm/gtc/constants.hpp>
#include <gtest/gtest.h>

#include "meshes/fields.hpp"
#include "meshes/random.hpp"
#include "meshes/shapes.hpp"
#include "meshes/variations.hpp"

namespace {

namespace verification = meshbound::verification;

using meshbound::Mesh;

/// Slivers that meet in one point, on a plane or a cone.
Mesh fan(unsigned count, double height) {
    std::vector<double> position = {0, 0, height};
    Mesh mesh;
    for (unsigned i = 0; i < count; ++i) {
        const double angle = glm::two_pi<double>() * i / count;
        position.insert(position.end(), {std::cos(angle), std::sin(angle), 0});
        mesh.triangles.push_back({0, 1 + i, 1 + (i + 1) % count});
    }
    mesh.position.values = position;
    return mesh;
}

/// A strip of slivers whose long edges lie across the axes.
Mesh diagonal_strip(unsigned count) {
    std::vector<double> position;
    Mesh mesh;
    for (unsigned i = 0; i <= count; ++i) {
        const double x = double(i) / count;
        for (const double y : {0.0, 1.0}) position.insert(position.end(), {x - y, x + y, 0.02 * std::sin(9 * x + y)});
        if (i == count) break;
        mesh.triangles.push_back({2 * i, 2 * i + 2, 2 * i + 3});
        mesh.triangles.push_back({2 * i, 2 * i + 3, 2 * i + 1});
    }
    mesh.position.values = position;
    return mesh;
}

struct Case {
    std::string name;
    Mesh mesh;
};

std::vector<Case> slivers(unsigned count) {
    std::vector<Case> cases = {{"flat fan", fan(count, 0)},
                               {"cone", fan(count, 0.7)},
                               {"diagonal strip", diagonal_strip(count / 2)},
                               {"cylinder", meshes::cylinder(int(count) / 2, 1)}};
    for (Case& one : cases) {
        meshes::add_scalar(one.mesh, "wave", [](glm::dvec3 p) { return std::sin(3 * p.x) + std::cos(2 * p.y); });
        meshes::add_scalar(one.mesh, "slope", [](glm::dvec3 p) { return p.x + 0.5 * p.y - p.z; });
    }
    return cases;
}

/// Every one with `multiplied` has multipliers, too.
class Searched {
public:
    Searched(const Mesh& mesh, bool multiplied)
        : space_(verification::joint_space(mesh, {0.01, 0.03, 0.02})),
          surface_(verification::joint_surface(mesh, space_)) {
        meshes::Random random(7);
        if (multiplied)
            for (std::size_t v = 0; v < vertex_count(mesh); ++v) surface_.multipliers.push_back(random.uniform(0.5, 2));
    }

    /// Points on the surface and off it.
    std::vector<double> point(meshes::Random& random) const {
        const auto& [a, b, c] = surface_.triangles[random.below(surface_.triangles.size())];
        const double u = random.uniform(0, 1), v = random.uniform(0, 1 - u);
        const double off = random.below(2) == 0 ? 0 : random.uniform(0, 3);
        std::vector<double> q;
        for (int k = 0; k < surface_.dimensions; ++k)
            q.push_back((1 - u - v) * surface_.row(a)[k] + u * surface_.row(b)[k] + v * surface_.row(c)[k] +
                        off * random.uniform(-1, 1));
        return q;
    }

    const verification::JointSurface& surface() const { return surface_; }
    const verification::JointSpace& space() const { return space_; }

private:
    verification::JointSpace space_;
    verification::JointSurface surface_;
};

/// Every triangle is looked at, by a tree of it alone.
double nearest_of_all(const Searched& searched, const std::vector<double>& q) {
    double least = verification::JointDistance::infinite;
    for (const auto& triangle : searched.surface().triangles) {
        verification::JointSurface one = searched.surface();
        one.triangles = {triangle};
        least =
            std::min(least, verification::JointTree(one, searched.space()).nearest(q.data(), 0, 0).nearest.distance);
    }
    return least;
}

TEST(JointTree, FindsTheNearestPointOfSlivers) {
    for (const bool multiplied : {false, true})
        for (const Case& one : slivers(60)) {
            SCOPED_TRACE(one.name);
            const Searched searched(one.mesh, multiplied);
            const verification::JointTree tree(searched.surface(), searched.space());
            meshes::Random random(3);
            for (int i = 0; i < 40; ++i) {
                const std::vector<double> q = searched.point(random);
                const double expected = nearest_of_all(searched, q);
                EXPECT_NEAR(tree.nearest(q.data(), 0, 0).nearest.distance, expected, 1e-6 * std::max(1.0, expected));
            }
        }
}

/// In a box around a whole sliver there is much else: with these a search looked at a fifth to a third of all triangles.
TEST(JointTree, LooksAtFewOfManySlivers) {
    for (const Case& one : slivers(4000)) {
        SCOPED_TRACE(one.name);
        const Searched searched(one.mesh, false);
        const verification::JointTree tree(searched.surface(), searched.space());
        meshes::Random random(5);
        constexpr std::size_t searches = 200;
        for (std::size_t i = 0; i < searches; ++i) {
            const std::vector<double> q = searched.point(random);
            tree.nearest(q.data(), 0.5, 0);
        }
        EXPECT_LE(tree.distances_found() / searches, searched.surface().triangles.size() / 20);
    }
}

TEST(JointTree, CutsNothingThatIsNotSlender) {
    Mesh mesh = meshes::sphere(6);
    const verification::JointSpace space = verification::joint_space(mesh, {0.01});
    EXPECT_EQ(verification::cut_into_fragments(verification::joint_surface(mesh, space)).size(), mesh.triangles.size());
}

} // namespace
