// The judge finds errors whose size is known in closed form, and none where there is none.

#include "judge/judge.hpp"

#include <cmath>
#include <limits>
#include <stdexcept>
#include <variant>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <gtest/gtest.h>

#include "judge/joint_tree.hpp"
#include "judge/sampling.hpp"
#include "meshes/defects.hpp"
#include "meshes/fields.hpp"
#include "meshes/random.hpp"
#include "meshes/shapes.hpp"
#include "meshes/variations.hpp"

namespace {

using judge::Judgement;
using meshes::Mesh;

constexpr double infinity = std::numeric_limits<double>::infinity();

double& value(auto& variable, std::size_t index) { return std::get<std::vector<double>>(variable.values)[index]; }

Mesh plane_with(const std::function<double(glm::dvec3)>& field, int columns = 8, int rows = 8) {
    Mesh mesh = meshes::plane(columns, rows);
    meshes::add_scalar(mesh, "f", field);
    return mesh;
}

TEST(Judge, FindsNothingBetweenASurfaceAndItself) {
    Mesh mesh = meshes::torus(20, 12);
    meshes::add_usual_fields(mesh);
    EXPECT_LT(judge::judge(mesh, mesh, {1e-3, 1e-3, 1e-3, 1e-3, 1e-3}).ratio(), 1e-6);
    EXPECT_LT(judge::judge(mesh, meshes::shuffled(mesh, 1), {1e-3, 1e-3, 1e-3, 1e-3, 1e-3}).ratio(), 1e-6);
}

TEST(Judge, FindsNothingBetweenTwoTriangulationsOfOnePlane) {
    const Mesh fine = plane_with(meshes::linear_field, 9, 7), coarse = plane_with(meshes::linear_field, 1, 1);
    EXPECT_LT(judge::judge(fine, coarse, {1e-3, 1e-3}).ratio(), 1e-6);
}

TEST(Judge, MeasuresAPeakInSpace) {
    const Mesh flat = meshes::plane(8, 8);
    Mesh peak = flat;
    value(peak.position, 3 * 40 + 2) = 0.02; // the middle vertex
    const Judgement lost = judge::judge(peak, flat, {0.01});
    EXPECT_NEAR(lost.from_original.ratio, 2, 1e-6);
    EXPECT_NEAR(lost.from_original.position[2], 0.02, 1e-12);
    EXPECT_EQ(lost.from_original.variable, 0U);
    // The other way the flank of the peak is nearer than its top: its slope is 0.02 to 1/8 along the axes.
    EXPECT_LT(lost.from_reduced.ratio, 2);
    EXPECT_GT(lost.from_reduced.ratio, 1.9);
    EXPECT_NEAR(judge::judge(flat, peak, {0.01}).from_reduced.ratio, 2, 1e-6);
}

TEST(Judge, MeasuresAPeakOfAVariable) {
    const Mesh flat = plane_with([](glm::dvec3) { return 7.0; });
    Mesh peak = flat;
    value(peak.variables[0], 40) = 7.5;
    const Judgement judgement = judge::judge(peak, flat, {0.01, 0.1});
    EXPECT_NEAR(judgement.from_original.ratio, 5, 1e-6);
    EXPECT_EQ(judgement.from_original.variable, 1U);
    EXPECT_LT(judge::judge(peak, flat, {0.01, infinity}).ratio(), 1e-6) << "a free variable does not count";
}

TEST(Judge, MeasuresAVectorByItsLength) {
    Mesh flat = meshes::plane(8, 8);
    meshes::add_vector(flat, "v", [](glm::dvec3) { return glm::dvec3(1, 2, 3); });
    Mesh peak = flat;
    value(peak.variables[0], 3 * 40) += 3;
    value(peak.variables[0], 3 * 40 + 1) += 4;
    EXPECT_NEAR(judge::judge(peak, flat, {1e-3, 1}).ratio(), 5, 1e-5);
}

TEST(Judge, TradesPositionAgainstVariables) {
    // The same slope f = x, moved by s in x. A point may give way in space by d, and must then bear s - d in f: both are
    // equal parts of their bounds at s / (bound of position + bound of f).
    const double s = 0.03, position_bound = 0.02, f_bound = 0.04;
    const Mesh slope = plane_with([](glm::dvec3 p) { return p.x; });
    Mesh moved = plane_with([s](glm::dvec3 p) { return p.x - s; });
    // At the rim x = 0 there is no room to give way, so only the inner part of the surface is compared.
    const Mesh inside = meshes::cut(moved, [](glm::dvec3 p) { return p.x > 0.25 && p.x < 0.75; });
    EXPECT_NEAR(judge::judge(slope, inside, {position_bound, f_bound}).from_reduced.ratio,
                s / (position_bound + f_bound), 1e-6);
}

TEST(Judge, SeesAMissingPart) {
    const Mesh whole = meshes::plane(10, 10);
    const Mesh part = meshes::cut(whole, [](glm::dvec3 p) { return p.x < 0.5; });
    const Judgement judgement = judge::judge(whole, part, {0.1});
    EXPECT_NEAR(judgement.from_original.ratio, 5, 1e-6);
    EXPECT_LT(judgement.from_reduced.ratio, 1e-6);
    EXPECT_NEAR(judge::judge(part, whole, {0.1}).from_reduced.ratio, 5, 1e-6);
}

TEST(Judge, SeesAnErrorAwayFromAllVertices) {
    // A saddle of four vertices, cut along one diagonal or the other: all vertices agree.
    const std::vector<glm::dvec3> corners = {{0, 0, 0.1}, {1, 0, 0}, {1, 1, 0.1}, {0, 1, 0}};
    const Mesh one = meshes::from_points(corners, {{0, 1, 2}, {0, 2, 3}});
    const Mesh other = meshes::from_points(corners, {{0, 1, 3}, {1, 2, 3}});
    // The ridge above the middle, 0.1 high, against the planes through the valley: x + y = 1 ± 10 z.
    EXPECT_NEAR(judge::judge(one, other, {0.01}).ratio(), 10 / std::sqrt(1.02), 0.02);
}

TEST(Judge, KeepsItsMeasureOverSixtyOrdersOfMagnitude) {
    Mesh flat = plane_with([](glm::dvec3) { return 1.0; });
    Mesh peak = flat;
    value(peak.variables[0], 40) = 1.5;
    for (const double unit : {1e-30, 1.0, 1e30}) {
        Mesh flat_scaled = flat, peak_scaled = peak;
        meshes::map_values(flat_scaled.variables[0].values, [unit](double x) { return x * unit; });
        meshes::map_values(peak_scaled.variables[0].values, [unit](double x) { return x * unit; });
        EXPECT_NEAR(judge::judge(peak_scaled, flat_scaled, {0.01, 0.1 * unit}).ratio(), 5, 1e-6) << unit;
    }
}

TEST(Judge, LooksOnlyAtTheSurface) {
    const Mesh plain = meshes::plane(4, 4);
    Mesh odd = meshes::with_degenerate_triangles(plain);
    odd.triangles.push_back({0, 0, 1}); // no surface
    std::get<std::vector<double>>(odd.position.values)
        .insert(std::get<std::vector<double>>(odd.position.values).end(), {9, 9, 9}); // a vertex of no triangle
    EXPECT_LT(judge::judge(odd, plain, {1e-3}).ratio(), 1e-6);
    EXPECT_LT(judge::judge(plain, odd, {1e-3}).ratio(), 1e-6);
}

TEST(Judge, ComparesBoundariesAsCurves) {
    const Mesh whole = meshes::plane(10, 10);
    EXPECT_LT(judge::judge_boundary(whole, meshes::plane(1, 1), {1e-3}).ratio(), 1e-6);
    // A hole inside: the surface is near everywhere, its boundary is not. Its far side lies 0.4 from the rim.
    const Mesh pierced =
        meshes::cut(whole, [](glm::dvec3 p) { return glm::max(std::abs(p.x - 0.5), std::abs(p.y - 0.5)) > 0.1; });
    EXPECT_NEAR(judge::judge_boundary(whole, pierced, {0.1}).from_reduced.ratio, 4, 0.5);
    EXPECT_LT(judge::judge_boundary(whole, pierced, {0.1}).from_original.ratio, 1e-6);
    EXPECT_EQ(judge::judge_boundary(meshes::cube(2), meshes::cube(3), {0.1}).ratio(), 0);
    EXPECT_EQ(judge::judge_boundary(whole, meshes::cube(3), {0.1}).ratio(), infinity);
}

TEST(Judge, CountsTrianglesOnTheSameThreeVerticesOnceWhereTheBoundaryIs) {
    const Mesh one = meshes::plane(8, 8), coarse = meshes::plane(1, 1);
    Mesh thrice = one, both_sides = one, coarse_sides = coarse;
    for (int n = 0; n < 2; ++n)
        for (const glm::uvec3& t : one.triangles) thrice.triangles.push_back({t.y, t.z, t.x});
    for (const glm::uvec3& t : one.triangles) both_sides.triangles.push_back({t.x, t.z, t.y});
    for (const glm::uvec3& t : coarse.triangles) coarse_sides.triangles.push_back({t.x, t.z, t.y});
    EXPECT_LT(judge::judge_boundary(thrice, coarse, {1e-3}).ratio(), 1e-6);
    EXPECT_LT(judge::judge_boundary(both_sides, coarse_sides, {1e-3}).ratio(), 1e-6);
    // The rim of a doubled sheet is one: half of the square leaves a corner at half the diagonal.
    Mesh cut = coarse_sides;
    cut.triangles = {coarse_sides.triangles[0], coarse_sides.triangles[2]};
    EXPECT_NEAR(judge::judge_boundary(both_sides, cut, {0.1}).from_original.ratio, std::sqrt(50), 1e-3);
}

std::vector<double> multipliers_of(const Mesh& mesh, const std::function<double(glm::dvec3)>& multiplier) {
    std::vector<double> multipliers;
    for (std::uint32_t v = 0; v < vertex_count(mesh); ++v) multipliers.push_back(multiplier(meshes::point(mesh, v)));
    return multipliers;
}

TEST(Judge, MultipliesBoundsAsTheyAreAtThePointOfTheOriginal) {
    // A plane lifted by two bounds; the multiplier rises from 1 by 2 along x, so by 0.02 a bound.
    const Mesh flat = meshes::plane(8, 8);
    const Mesh lifted = meshes::mapped(flat, [](glm::dvec3 p) { return p + glm::dvec3(0, 0, 0.02); });
    const auto rising = multipliers_of(flat, [](glm::dvec3 p) { return 1 + 2 * p.x; });
    const Judgement judgement = judge::judge(flat, lifted, {0.01}, judge::usual_samples, rising);
    EXPECT_NEAR(judgement.from_original.ratio, 2, 1e-6);
    EXPECT_NEAR(judgement.from_original.position[0], 0, 1e-12);
    // A point above x = 0 may look d bounds aside, where the multiplier is 1 + 0.02 d: the least of sqrt(4 + d^2) / (1 + 0.02 d).
    EXPECT_NEAR(judgement.from_reduced.ratio, 1 / std::sqrt(0.25 + 0.02 * 0.02), 1e-6);

    const Judgement boundary = judge::judge_boundary(flat, lifted, {0.01}, judge::usual_samples, rising);
    EXPECT_NEAR(boundary.from_original.ratio, 2, 1e-6);
    EXPECT_NEAR(boundary.from_reduced.ratio, 2, 1e-6) << "the edge above x = 0 cannot look aside";

    const std::vector<double> five(vertex_count(flat), 5);
    EXPECT_NEAR(judge::judge(flat, lifted, {0.01}, judge::usual_samples, five).ratio(), 0.4, 1e-6);
}

TEST(Judge, RefusesMultipliersThatAreNone) {
    const Mesh mesh = meshes::plane(1, 1);
    for (const std::vector<double>& bad :
         {std::vector<double>{1, 1}, {1, 1, 1, 0}, {1, 1, 1, -1}, {1, 1, 1, std::nan("")}, {1, 1, 1, infinity}})
        EXPECT_THROW(judge::judge(mesh, mesh, {1}, 10, bad), std::invalid_argument);
}

TEST(Judge, RefusesWhatCannotBeCompared) {
    const Mesh one = plane_with(meshes::linear_field), other = meshes::plane(2, 2);
    EXPECT_THROW(judge::judge(one, other, {1, 1}), std::invalid_argument);
    EXPECT_THROW(judge::judge(one, one, {1}), std::invalid_argument);
    EXPECT_THROW(judge::judge(one, one, {1, 0}), std::invalid_argument);
    EXPECT_THROW(judge::judge(one, one, {1, std::nan("")}), std::invalid_argument);
}

TEST(JointTree, FindsTheNearestOfAllTriangles) {
    Mesh mesh = meshes::torus(14, 10);
    meshes::add_usual_fields(mesh);
    const judge::JointSpace space = judge::joint_space(mesh, {0.1, 0.5, 0.2, 0.3, 0.4});
    const judge::JointSurface surface = judge::joint_surface(mesh, space);
    const judge::JointTree tree(surface, space);
    const judge::JointDistance metric(space.components);
    meshes::Random random(1);
    for (int i = 0; i < 300; ++i) {
        std::vector<double> q(static_cast<std::size_t>(space.dimensions()));
        for (double& x : q) x = random.uniform(-8, 8);
        double least = infinity;
        for (const auto& [a, b, c] : surface.triangles)
            least =
                std::min(least, metric.to_triangle(q.data(), surface.row(a), surface.row(b), surface.row(c)).distance);
        const auto guess = static_cast<std::uint32_t>(random.below(surface.triangles.size()));
        EXPECT_NEAR(tree.nearest(q.data(), 0, guess).nearest.distance, least, 1e-6 * least);
        EXPECT_LE(tree.nearest(q.data(), 1.2 * least, guess).nearest.distance, 1.2 * least);
    }
}

/// Against points all over the surface, with multipliers that differ tenfold from corner to corner.
TEST(JointTree, FindsTheSmallestShareOfTheMultipliedBounds) {
    Mesh mesh = meshes::torus(8, 5);
    meshes::add_usual_fields(mesh);
    const judge::JointSpace space = judge::joint_space(mesh, {0.1, 0.5, 0.2, 0.3, 0.4});
    judge::JointSurface surface = judge::joint_surface(mesh, space);
    meshes::Random random(2);
    for (std::size_t v = 0; v < vertex_count(mesh); ++v) surface.multipliers.push_back(random.uniform(0.2, 2));
    const judge::JointTree tree(surface, space);
    const judge::JointDistance metric(space.components);
    std::vector<double> q(static_cast<std::size_t>(space.dimensions())), p = q;
    const auto share_at = [&](std::size_t triangle, double u, double v) {
        const auto& [a, b, c] = surface.triangles[triangle];
        const auto mixed = [=](double at_a, double at_b, double at_c) {
            return (1 - u - v) * at_a + u * at_b + v * at_c;
        };
        for (std::size_t k = 0; k < p.size(); ++k)
            p[k] = mixed(surface.row(a)[k], surface.row(b)[k], surface.row(c)[k]);
        const std::vector<double>& m = surface.multipliers;
        return metric.between(q.data(), p.data()) / mixed(m[a], m[b], m[c]);
    };
    constexpr int steps = 40;
    for (int n = 0; n < 20; ++n) {
        for (double& x : q) x = random.uniform(-8, 8);
        double least = infinity;
        for (std::size_t t = 0; t < surface.triangles.size(); ++t)
            for (int i = 0; i <= steps; ++i)
                for (int j = 0; i + j <= steps; ++j)
                    least = std::min(least, share_at(t, i / double(steps), j / double(steps)));
        const judge::Foot foot = tree.nearest(q.data(), 0, 0);
        EXPECT_LE(foot.nearest.distance, least * (1 + 1e-6));
        EXPECT_GT(foot.nearest.distance, 0.95 * least);
        EXPECT_NEAR(share_at(foot.triangle, foot.nearest.u, foot.nearest.v), foot.nearest.distance, 1e-6 * least);
    }
}

TEST(Sampling, SpendsItsBudgetWhereTheSurfaceIsLarge) {
    // A small and a large square: most samples fall on the large one.
    const Mesh mesh =
        meshes::joined(meshes::plane(1, 1, 0.1, 0.1),
                       meshes::mapped(meshes::plane(1, 1), [](glm::dvec3 p) { return p + glm::dvec3(5, 0, 0); }));
    const judge::JointSpace space = judge::joint_space(mesh, {0.01});
    const judge::JointSurface surface = judge::joint_surface(mesh, space);
    std::size_t on_small = 0, on_large = 0;
    judge::sample_surface(surface, 10'000, [&](const judge::Sample& sample) {
        ++(sample.triangle < 2 ? on_small : on_large);
        double sum = 0;
        for (double x : sample.barycentric) {
            EXPECT_GE(x, -1e-15);
            sum += x;
        }
        EXPECT_NEAR(sum, 1, 1e-15);
    });
    EXPECT_NEAR(static_cast<double>(on_small + on_large), 10'000, 100);
    EXPECT_GT(on_large, 50 * on_small);
    EXPECT_GE(on_small, 4U + 5U + 2U) << "every vertex, edge and triangle";
}

TEST(Sampling, LeavesNoPartOfATriangleFarFromASample) {
    const Mesh mesh = meshes::from_points({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}});
    const judge::JointSpace space = judge::joint_space(mesh, {1});
    std::vector<glm::dvec2> samples;
    judge::sample_surface(judge::joint_surface(mesh, space), 2'000, [&](const judge::Sample& sample) {
        samples.push_back({sample.barycentric[1], sample.barycentric[2]});
    });
    meshes::Random random(3);
    for (int i = 0; i < 1000; ++i) {
        glm::dvec2 p(random.uniform(0, 1), random.uniform(0, 1));
        if (p.x + p.y > 1) p = 1.0 - p;
        double nearest = infinity;
        for (const glm::dvec2& s : samples) nearest = std::min(nearest, glm::distance(p, s));
        EXPECT_LT(nearest, 0.04) << "at " << p.x << ", " << p.y;
    }
}

} // namespace
