// Bounds that vary over the surface: a variable multiplies them, and they hold at every point of the original.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <utility>
#include <variant>
#include <vector>

#include <glm/geometric.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "guarantee.hpp"
#include "map_certificate.hpp"
#include "meshes/defects.hpp"
#include "meshes/fields.hpp"
#include "meshes/shapes.hpp"
#include "meshes/variations.hpp"
#include "modes.hpp"

namespace {

using namespace meshbound;

class Focus : public ModeTest {
protected:
    Options options() const {
        Options options = GetParam().options();
        options.bound_multiplier = "sharpness";
        return options;
    }
    Reduction reduce(const Mesh& mesh, const Bounds& bounds) const {
        return guarantee::reduced(mesh, bounds, options());
    }
};
EVERY_MODE(Focus);

/// What there is only where the map is kept.
class MappedFocus : public Focus {};
EVERY_TRACKED_MODE(MappedFocus);

double multiplier(const Mesh& mesh, std::uint32_t vertex) { return value_at(mesh.variables.back(), vertex, 0); }

/// The bounds free of the multiplier: it is a variable without a bound.
Bounds bounds_of(double geometry, double variables) {
    Bounds bounds = guarantee::percent(geometry, variables);
    bounds.push_back({"sharpness", unbounded()});
    return bounds;
}

/// The judge, who knows the multiplier at each point of the original, finds every bound kept, multiplied so.
void expect_judge_agrees(const Mesh& mesh, const Reduction& reduction) {
    const std::vector<double> bounds = guarantee::absolute_bounds(reduction);
    std::vector<double> multipliers;
    for (std::uint32_t v = 0; v < vertex_count(mesh); ++v) multipliers.push_back(multiplier(mesh, v));
    const double claimed = guarantee::largest_ratio(reduction) + guarantee::hair;
    EXPECT_LE(judge::judge(mesh, reduction.mesh, bounds, 20'000, multipliers).ratio(), claimed);
    EXPECT_LE(judge::judge_boundary(mesh, reduction.mesh, bounds, 2'000, multipliers).ratio(), claimed);
}

Mesh with_sharpness(Mesh mesh, const std::function<double(glm::dvec3)>& sharpness) {
    meshes::add_scalar(mesh, "wave", meshes::wave_field);
    meshes::add_vector(mesh, "whirl", meshes::whirl_field);
    meshes::add_scalar(mesh, "sharpness", sharpness);
    return mesh;
}

double near_a_point(glm::dvec3 p) {
    const glm::dvec3 away = p - glm::dvec3(1, 0, 0.5);
    return std::clamp(glm::dot(away, away), 0.02, 1.0);
}

/// Neighbouring vertices differ hundredfold: what a bound looked up in the wrong place would get away with.
double checkered(glm::dvec3 p) { return std::sin(40 * p.x) * std::sin(40 * p.y) > 0 ? 0.02 : 2; }

TEST_P(Focus, BoundsHoldAtEveryPointTimesTheMultiplierThere) {
    for (const auto& sharpness : {near_a_point, checkered})
        for (const Mesh& plain : {meshes::noisy_sphere(12, 0.05, 3), meshes::terrain(5, 7), meshes::three_sheets(8),
                                  meshes::cylinder(24, 12)}) {
            const Mesh mesh = with_sharpness(plain, sharpness);
            const Reduction reduction = reduce(mesh, bounds_of(2, 6));
            guarantee::expect_vertex_subset(mesh, reduction);
            guarantee::expect_same_topology(mesh, reduction);
            expect_judge_agrees(mesh, reduction);
            EXPECT_LT(reduction.mesh.triangles.size(), mesh.triangles.size());
            EXPECT_LE(guarantee::largest_ratio(reduction), 1);
        }
}

TEST_P(MappedFocus, TheMapProvesThem) {
    for (const auto& sharpness : {near_a_point, checkered}) {
        const Mesh mesh = with_sharpness(meshes::noisy_sphere(12, 0.05, 3), sharpness);
        const Reduction reduction = reduce(mesh, bounds_of(2, 6));
        const certificate::Certificate certificate(mesh, reduction);
        EXPECT_THAT(certificate.faults(), testing::IsEmpty());
        for (std::size_t i = 0; i + 1 < reduction.report.variables.size(); ++i) {
            const VariableReport& variable = reduction.report.variables[i];
            double ratio = 0;
            for (std::uint32_t v = 0; v < vertex_count(mesh); ++v) {
                const double here = certificate.error_at_vertex(i, v) / multiplier(mesh, v);
                const std::uint32_t triangle = reduction.map.images[v].triangle;
                EXPECT_LE(here / variable.bound.absolute,
                          reduction.triangle_errors[i].ratio[triangle] + guarantee::hair);
                ratio = std::max(ratio, here);
            }
            for (const MapCrossing& x : reduction.map.crossings) {
                const double p = multiplier(mesh, x.original.x), q = multiplier(mesh, x.original.y);
                ratio = std::max(ratio, certificate.error_at_crossing(i, x) / (p + x.s * (q - p)));
            }
            ratio /= variable.bound.absolute;
            EXPECT_LE(ratio, 1 + guarantee::hair) << variable.name;
            EXPECT_NEAR(ratio, variable.ratio, 1e-6) << variable.name;
        }
    }
}

TEST_P(Focus, KeepsMoreTrianglesWhereItIsSharp) {
    const Mesh mesh = with_sharpness(meshes::terrain(6, 3), [](glm::dvec3 p) { return p.x < 0.5 ? 0.02 : 1.0; });
    const Reduction reduction = reduce(mesh, bounds_of(2, 10));
    std::size_t sharp = 0;
    for (const glm::uvec3& t : reduction.mesh.triangles) {
        double x = 0;
        for (int i = 0; i < 3; ++i) x += meshes::point(reduction.mesh, t[i]).x / 3;
        sharp += x < 0.5;
    }
    EXPECT_GT(sharp, 5 * (reduction.mesh.triangles.size() - sharp));
}

TEST_P(Focus, OneEverywhereChangesNothing) {
    const Mesh mesh = with_sharpness(meshes::noisy_sphere(10, 0.05, 3), [](glm::dvec3) { return 1.0; });
    const Reduction with = reduce(mesh, bounds_of(2, 6));
    const Reduction without = guarantee::reduced(mesh, bounds_of(2, 6), GetParam().options());
    EXPECT_TRUE(guarantee::same_bits(with.mesh, without.mesh));
}

TEST_P(Focus, HoldsInEveryLevel) {
    const Mesh mesh = with_sharpness(meshes::noisy_sphere(12, 0.05, 3), near_a_point);
    Levels levels;
    LevelOptions how{options(), true, true};
    ASSERT_TRUE(reduce_levels(mesh, {bounds_of(1, 3), bounds_of(3, 9)}, how, levels).ok());
    for (const Reduction& level : levels.levels) expect_judge_agrees(mesh, level);
}

TEST_P(Focus, OfWhatCannotMultiplyIsRefused) {
    Mesh mesh = with_sharpness(meshes::plane(4, 4), [](glm::dvec3) { return 1.0; });
    const auto fault = [&](const std::string& focus) {
        Options how = GetParam().options();
        how.bound_multiplier = focus;
        Reduction reduction;
        return meshbound::reduce(mesh, bounds_of(1, 1), how, reduction);
    };
    EXPECT_EQ(fault("sharpnes").fault, Fault::unknown_variable);
    EXPECT_EQ(fault("whirl").fault, Fault::bad_option) << "three components";
    auto& values = std::get<std::vector<double>>(mesh.variables.back().values);
    for (const double bad : {0.0, -0.5}) {
        values[7] = bad;
        const Status status = fault("sharpness");
        EXPECT_EQ(status.fault, Fault::bad_option);
        EXPECT_EQ(status.index, 7U);
        EXPECT_EQ(status.variable, "sharpness");
    }
    values[7] = 1e-14;
    EXPECT_EQ(fault("sharpness").fault, Fault::bound_too_fine);
}

} // namespace
