// What must not change the outcome: units, place, running twice.

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "guarantee.hpp"
#include "meshes/fields.hpp"
#include "meshes/shapes.hpp"
#include "meshes/variations.hpp"
#include "modes.hpp"

namespace {

using namespace meshbound;

class Invariance : public ModeTest {
protected:
    Reduction reduce(const Mesh& mesh) const {
        return guarantee::reduced(mesh, guarantee::percent(1, 5), GetParam().options());
    }
    void expect_same_outcome(const Mesh& one, const Mesh& other) const {
        const Reduction of_one = reduce(one), of_other = reduce(other);
        EXPECT_EQ(of_one.vertices, of_other.vertices);
        EXPECT_EQ(of_one.mesh.triangles, of_other.mesh.triangles);
        for (std::size_t i = 0; i < of_one.report.variables.size(); ++i)
            EXPECT_EQ(of_one.report.variables[i].ratio, of_other.report.variables[i].ratio);
    }
};
EVERY_MODE(Invariance);

/// A surface all of whose numbers are multiples of 2^-20 below 8, so that moving them by up to 2^20 is exact.
Mesh coarse_numbers() {
    Mesh mesh = meshes::torus(32, 16);
    meshes::add_usual_fields(mesh);
    const auto coarse = [](double x) { return std::round(x * 0x1p20) * 0x1p-20; };
    meshes::map_values(mesh.position.values, coarse);
    for (Variable& variable : mesh.variables) meshes::map_values(variable.values, coarse);
    return mesh;
}

TEST_P(Invariance, RunningTwiceGivesTheSameBytes) {
    const Mesh mesh = coarse_numbers();
    const Reduction one = reduce(mesh), other = reduce(mesh);
    EXPECT_TRUE(guarantee::same_bits(one.mesh, other.mesh));
    EXPECT_EQ(one.vertices, other.vertices);
    for (std::size_t i = 0; i < one.triangle_errors.size(); ++i) {
        EXPECT_EQ(one.triangle_errors[i].largest, other.triangle_errors[i].largest);
        EXPECT_EQ(one.triangle_errors[i].lowest, other.triangle_errors[i].lowest);
        EXPECT_EQ(one.triangle_errors[i].highest, other.triangle_errors[i].highest);
    }
}

TEST_P(Invariance, ScalingByPowersOfTwoChangesNothing) {
    for (const double scale : {0x1p-100, 0x1p-40, 0x1p-1, 0x1p10, 0x1p100}) { // 1e-30 … 1e30
        SCOPED_TRACE(scale);
        for (const Mesh& mesh : {coarse_numbers(), meshes::in_single(coarse_numbers())}) {
            Mesh scaled = mesh;
            meshes::map_values(scaled.position.values, [scale](double x) { return x * scale; });
            expect_same_outcome(mesh, scaled);
            for (Variable& variable : scaled.variables)
                meshes::map_values(variable.values, [scale](double x) { return x / scale; });
            expect_same_outcome(mesh, scaled);
        }
    }
}

TEST_P(Invariance, MovingChangesNothing) {
    const Mesh mesh = coarse_numbers();
    Mesh moved = meshes::mapped(mesh, [](glm::dvec3 p) { return p + glm::dvec3(0x1p20, -0x1p17, 12345); });
    expect_same_outcome(mesh, moved);
    for (Variable& variable : moved.variables) meshes::map_values(variable.values, [](double x) { return x - 1000; });
    expect_same_outcome(mesh, moved);
}

TEST_P(Invariance, PrecisionOfTheInputChangesNothingButItself) {
    // The same numbers as floats and as doubles.
    const Mesh single = meshes::in_single(coarse_numbers());
    Mesh widened = single;
    widened.position.values = std::vector<double>(std::get<std::vector<float>>(single.position.values).begin(),
                                                  std::get<std::vector<float>>(single.position.values).end());
    expect_same_outcome(single, widened);
    EXPECT_TRUE(std::holds_alternative<std::vector<float>>(reduce(single).mesh.position.values));
    EXPECT_TRUE(std::holds_alternative<std::vector<double>>(reduce(widened).mesh.position.values));
    EXPECT_TRUE(std::holds_alternative<std::vector<float>>(reduce(widened).mesh.variables[0].values));
}

TEST_P(Invariance, FarFromTheOriginTheGuaranteeStillHolds) {
    Mesh mesh = meshes::torus(32, 16);
    meshes::add_usual_fields(mesh);
    mesh = meshes::mapped(mesh, [](glm::dvec3 p) { return p + glm::dvec3(3e6, -2e6, 1e6); });
    for (Variable& variable : mesh.variables) meshes::map_values(variable.values, [](double x) { return x + 1e5; });
    for (const Mesh& far : {mesh, meshes::in_single(mesh)}) guarantee::expect_everything(far, reduce(far));
}

TEST_P(Invariance, TurningTheSurfaceInsideOutGivesTheGuarantee) {
    const Mesh mesh = meshes::reversed(coarse_numbers());
    const Reduction reduction = reduce(mesh);
    EXPECT_LT(meshes::enclosed_volume(reduction.mesh), 0);
    guarantee::expect_everything(mesh, reduction);
}

TEST_P(Invariance, ReducingAgainGivesTheGuaranteeTowardsTheFirstResult) {
    const Mesh mesh = coarse_numbers();
    const Reduction once = reduce(mesh);
    guarantee::expect_everything(once.mesh, reduce(once.mesh));
}

} // namespace
