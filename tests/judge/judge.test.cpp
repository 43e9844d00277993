// The judge finds errors whose size is known in closed form, and none where there is none.

#include "judge/judge.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <gtest/gtest.h>

#include "meshes/defects.hpp"
#include "meshes/fields.hpp"
#include "meshes/random.hpp"
#include "meshes/shapes.hpp"
#include "meshes/variations.hpp"
#include "verify/joint_tree.hpp"
#include "verify/sampling.hpp"

namespace {

using meshbound::Judgement;
namespace verification = meshbound::verification;
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

struct Refused {
    const char* what;
    Mesh original, reduced;
    std::vector<double> bounds;
    meshbound::Fault fault;
    std::string variable;
    std::vector<double> multipliers{};
};

std::vector<Refused> refused() {
    using meshbound::Fault;
    const Mesh good = plane_with(meshes::linear_field, 2, 2);
    const auto changed = [&](const auto& change) {
        Mesh mesh = good;
        change(mesh);
        return mesh;
    };
    const Mesh bad_index = changed([](Mesh& m) { m.triangles[1].y = 99; });
    const Mesh empty = changed([](Mesh& m) { m.triangles.clear(); });
    const Mesh few = changed([](Mesh& m) { std::get<std::vector<double>>(m.variables[0].values).pop_back(); });
    const Mesh nan = changed([](Mesh& m) { value(m.variables[0], 4) = std::nan(""); });
    const Mesh infinite = changed([](Mesh& m) { value(m.position, 4) = infinity; });
    const Mesh renamed = changed([](Mesh& m) { m.variables[0].name = "g"; });
    const Mesh without = changed([](Mesh& m) { m.variables.clear(); });
    const Mesh of_three = changed([](Mesh& m) {
        m.variables.clear();
        meshes::add_vector(m, "f", [](glm::dvec3 p) { return p; });
    });
    return {
        {"index of the original", bad_index, good, {1, 1}, Fault::bad_index, ""},
        {"index of the reduced", good, bad_index, {1, 1}, Fault::bad_index, ""},
        {"empty original", empty, good, {1, 1}, Fault::no_triangles, ""},
        {"empty reduced", good, empty, {1, 1}, Fault::no_triangles, ""},
        {"nothing at all", {}, {}, {1}, Fault::no_triangles, ""},
        {"too few values", good, few, {1, 1}, Fault::wrong_value_count, "f"},
        {"not a number", nan, good, {1, 1}, Fault::non_finite_value, "f"},
        {"not a number", good, nan, {1, 1}, Fault::non_finite_value, "f"},
        {"infinite place", good, infinite, {1, 1}, Fault::non_finite_position, "position"},
        {"another variable", good, renamed, {1, 1}, Fault::unknown_variable, "f"},
        {"no variable", good, without, {1, 1}, Fault::unknown_variable, "f"},
        {"a vector", good, of_three, {1, 1}, Fault::bad_components, "f"},
        {"too few bounds", good, good, {1}, Fault::bad_bound, ""},
        {"no bounds", good, good, {}, Fault::bad_bound, ""},
        {"bound of zero", good, good, {1, 0}, Fault::bad_bound, "f"},
        {"bound below zero", good, good, {-1, 1}, Fault::bad_bound, "position"},
        {"bound that is no number", good, good, {1, std::nan("")}, Fault::bad_bound, "f"},
        {"bound too fine", good, good, {1e-10, 1}, Fault::bound_too_fine, "position"},
        {"bound next to nothing", good, good, {1, 5e-324}, Fault::bound_too_fine, "f"},
        {"too few multipliers", good, good, {1, 1}, Fault::bad_option, "", {1, 1}},
        {"multiplier of zero", good, good, {1, 1}, Fault::bad_option, "", {1, 1, 1, 1, 0, 1, 1, 1, 1}},
    };
}

TEST(Verify, NamesWhatIsWrongAndLeavesTheVerdict) {
    for (const Refused& each : refused()) {
        meshbound::Verdict verdict;
        verdict.cancelled = true;
        const meshbound::Status status =
            verify(each.original, each.reduced, each.bounds, {100, 100, each.multipliers}, verdict);
        EXPECT_EQ(status.fault, each.fault) << each.what << ": " << status.message;
        EXPECT_EQ(status.variable, each.variable) << each.what;
        EXPECT_FALSE(status.message.empty()) << each.what;
        EXPECT_TRUE(verdict.cancelled) << each.what;
    }
}

TEST(Verify, SaysWhichOfTheTwoSurfacesIsAtFault) {
    const Mesh good = meshes::plane(2, 2);
    Mesh bad = good;
    bad.triangles[3].x = 12;
    meshbound::Verdict verdict;
    EXPECT_EQ(verify(bad, good, {1}, {}, verdict).message,
              "In the original surface: Triangle 3 names vertex 12, but the mesh has 9 vertices (counted from 0).");
    const meshbound::Status status = verify(good, bad, {1}, {}, verdict);
    EXPECT_EQ(status.message,
              "In the reduced surface: Triangle 3 names vertex 12, but the mesh has 9 vertices (counted from 0).");
    EXPECT_EQ(status.index, 3U);
}

/// Askew, so that rounding has its way.
glm::dvec3 turned(glm::dvec3 p) {
    return {0.36 * p.x + 0.48 * p.y - 0.8 * p.z + 0.1, -0.8 * p.x + 0.6 * p.y + 0.7,
            0.48 * p.x + 0.64 * p.y + 0.6 * p.z + 0.3};
}

TEST(Verify, IsAccurateWhereTheSurfaceIsVeryWideInBounds) {
    for (const double bound : {1e-3, 1e-6, 1e-9}) {
        const auto lifted = [bound](glm::dvec3 p) { return turned(p + glm::dvec3(0, 0, 2 * bound)); };
        const Mesh fine = meshes::mapped(meshes::plane(9, 7), turned),
                   coarse = meshes::mapped(meshes::plane(2, 3), turned);
        const Mesh higher = meshes::mapped(meshes::plane(2, 3), lifted);
        EXPECT_LT(judge::judge(fine, coarse, {bound}, 5'000).ratio(), 1e-6) << bound;
        EXPECT_NEAR(judge::judge(fine, higher, {bound}, 5'000).ratio(), 2, 1e-6) << bound;
    }
}

TEST(Verify, TakesWhatIsFreeAsItComes) {
    Mesh one = plane_with(meshes::linear_field, 4, 4), other = one;
    value(one.variables[0], 3) = std::nan("");
    other.variables.clear();
    EXPECT_TRUE(judge::verdict_of(one, other, {0.01, infinity}).within_bounds());
    const meshbound::Verdict free = judge::verdict_of(one, other, {infinity, infinity});
    EXPECT_TRUE(free.within_bounds());
    EXPECT_EQ(free.surface.from_original.samples, 0U) << "there is nothing to look for";
}

TEST(Verify, ReportsProgressThatNeverFalls) {
    const Mesh mesh = plane_with(meshes::linear_field, 30, 30);
    std::vector<double> steps;
    meshbound::Verdict verdict;
    ASSERT_TRUE(verify(mesh, mesh, {0.1, 0.1}, {}, verdict, [&](double progress) {
                    steps.push_back(progress);
                    return true;
                }).ok());
    EXPECT_GT(steps.size(), 100U);
    EXPECT_TRUE(std::is_sorted(steps.begin(), steps.end()));
    EXPECT_GE(steps.front(), 0);
    EXPECT_EQ(steps.back(), 1);
}

TEST(Verify, ProvesNothingWhereItIsCancelled) {
    const Mesh mesh = plane_with(meshes::linear_field, 30, 30);
    for (const int calls : {0, 1, 5, 50}) {
        int left = calls;
        meshbound::Verdict verdict;
        ASSERT_TRUE(verify(mesh, mesh, {0.1, 0.1}, {}, verdict, [&](double) { return left-- > 0; }).ok());
        EXPECT_EQ(left, -1) << "it is not asked again";
        EXPECT_TRUE(verdict.cancelled);
        EXPECT_FALSE(verdict.within_bounds());
        EXPECT_LT(verdict.surface.from_original.samples + verdict.surface.from_reduced.samples, 100'000U);
    }
}

TEST(JointTree, FindsTheNearestOfAllTriangles) {
    Mesh mesh = meshes::torus(14, 10);
    meshes::add_usual_fields(mesh);
    const verification::JointSpace space = verification::joint_space(mesh, {0.1, 0.5, 0.2, 0.3, 0.4});
    const verification::JointSurface surface = verification::joint_surface(mesh, space);
    const verification::JointTree tree(surface, space);
    const verification::JointDistance metric(space.components);
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
    const verification::JointSpace space = verification::joint_space(mesh, {0.1, 0.5, 0.2, 0.3, 0.4});
    verification::JointSurface surface = verification::joint_surface(mesh, space);
    meshes::Random random(2);
    for (std::size_t v = 0; v < vertex_count(mesh); ++v) surface.multipliers.push_back(random.uniform(0.2, 2));
    const verification::JointTree tree(surface, space);
    const verification::JointDistance metric(space.components);
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
        const verification::Foot foot = tree.nearest(q.data(), 0, 0);
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
    const verification::JointSpace space = verification::joint_space(mesh, {0.01});
    const verification::JointSurface surface = verification::joint_surface(mesh, space);
    std::size_t on_small = 0, on_large = 0;
    verification::sample_surface(surface, 10'000, [&](const verification::Sample& sample) {
        ++(sample.triangle < 2 ? on_small : on_large);
        double sum = 0;
        for (double x : sample.barycentric) {
            EXPECT_GE(x, -1e-15);
            sum += x;
        }
        EXPECT_NEAR(sum, 1, 1e-15);
        return true;
    });
    EXPECT_NEAR(static_cast<double>(on_small + on_large), 10'000, 100);
    EXPECT_GT(on_large, 50 * on_small);
    EXPECT_GE(on_small, 4U + 5U + 2U) << "every vertex, edge and triangle";
}

TEST(Sampling, LeavesNoPartOfATriangleFarFromASample) {
    const Mesh mesh = meshes::from_points({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}});
    const verification::JointSpace space = verification::joint_space(mesh, {1});
    std::vector<glm::dvec2> samples;
    verification::sample_surface(verification::joint_surface(mesh, space), 2'000,
                                 [&](const verification::Sample& sample) {
                                     samples.push_back({sample.barycentric[1], sample.barycentric[2]});
                                     return true;
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
