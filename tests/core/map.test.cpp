// The map that tracked errors give out is continuous, and its errors are those reported: checked from the map alone.

#include <cmath>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "guarantee.hpp"
#include "map_certificate.hpp"
#include "meshes/defects.hpp"
#include "meshes/fields.hpp"
#include "meshes/gallery.hpp"
#include "meshes/shapes.hpp"
#include "meshes/variations.hpp"
#include "modes.hpp"
#include "samples.hpp"

namespace {

using namespace meshbound;
using certificate::Certificate;
using certificate::Step;

class Map : public ModeTest {
protected:
    Reduction reduce(const Mesh& mesh, const Bounds& bounds) const {
        return guarantee::reduced(mesh, bounds, GetParam().options());
    }
    /// The map proves every bound, and the report states its errors exactly.
    static void expect_proof(const Mesh& mesh, const Reduction& reduction) {
        const Certificate certificate(mesh, reduction);
        EXPECT_THAT(certificate.faults(), testing::IsEmpty());
        const std::vector<double> errors = certificate.largest_errors();
        for (std::size_t i = 0; i < errors.size(); ++i) {
            const VariableReport& variable = reduction.report.variables[i];
            EXPECT_LE(errors[i], variable.bound.absolute * (1 + guarantee::hair)) << variable.name;
            const double rounding = 1e-6 * variable.error + 1e-12 * (variable.bound.extent + variable.bound.magnitude);
            EXPECT_NEAR(errors[i], variable.error, rounding) << variable.name;
        }
    }
};
INSTANTIATE_TEST_SUITE_P(TrackedModes, Map, testing::ValuesIn(tracked_modes()), mode_name);

TEST_P(Map, ProvesTheGuaranteeOverEveryKindOfSurface) {
    for (const meshes::Exhibit& exhibit : meshes::gallery())
        for (const Bounds& bounds : {guarantee::percent(1, 3), guarantee::percent(6, 10)}) {
            SCOPED_TRACE(exhibit.name);
            expect_proof(exhibit.mesh, reduce(exhibit.mesh, bounds));
        }
}

TEST_P(Map, ProvesTheGuaranteeOverOddSurfaces) {
    std::size_t number = 0;
    for (const Mesh& odd : meshes::odd_surfaces()) {
        SCOPED_TRACE(number++);
        expect_proof(odd, reduce(odd, guarantee::percent(3, 10)));
    }
}

TEST_P(Map, ProvesTheGuaranteeWhereNearlyNothingIsLeft) {
    for (const meshes::Exhibit& exhibit : meshes::gallery()) {
        SCOPED_TRACE(exhibit.name);
        expect_proof(exhibit.mesh, reduce(exhibit.mesh, {{"position", relative(0.5)}}));
    }
}

TEST_P(Map, ProvesTheGuaranteeOverSamples) {
    for_each_sample(15'000, [this](const Mesh& mesh) { expect_proof(mesh, reduce(mesh, guarantee::percent(1, 3))); });
}

TEST_P(Map, IsTheIdentityWhereNothingWasRemoved) {
    const Mesh mesh = meshes::noisy_sphere(6, 0.1, 1);
    const Reduction reduction = reduce(mesh, {{"position", relative(1e-9)}});
    ASSERT_EQ(reduction.mesh.triangles.size(), mesh.triangles.size());
    EXPECT_TRUE(reduction.map.crossings.empty());
    expect_proof(mesh, reduction);
}

TEST_P(Map, GivesTheErrorsOfTheVertices) {
    Mesh mesh = meshes::torus(30, 16);
    meshes::add_usual_fields(mesh);
    const Reduction reduction = reduce(mesh, guarantee::percent(2, 6));
    const Certificate certificate(mesh, reduction);
    ASSERT_EQ(reduction.vertex_errors.size(), 1 + mesh.variables.size());
    for (std::size_t i = 0; i < reduction.vertex_errors.size(); ++i) {
        const VertexErrors& errors = reduction.vertex_errors[i];
        const bool is_signed = i == 0 || mesh.variables[i - 1].components == 1;
        ASSERT_EQ(errors.error.size(), vertex_count(mesh));
        ASSERT_EQ(errors.signed_error.size(), is_signed ? vertex_count(mesh) : 0);
        const double scale = reduction.report.variables[i].bound.extent;
        for (std::uint32_t v = 0; v < errors.error.size(); ++v) {
            EXPECT_NEAR(errors.error[v], certificate.error_at_vertex(i, v), 1e-6 * scale);
            if (!is_signed) continue;
            const double largest_signed = std::abs(errors.signed_error[v]);
            if (i == 0) EXPECT_LE(largest_signed, errors.error[v] + 1e-6 * scale) << "a part of the displacement";
            else EXPECT_NEAR(largest_signed, errors.error[v], 1e-6 * scale);
        }
    }
}

TEST_P(Map, CountsTheReducedSurfaceInsideASphereAsNegative) {
    const Mesh mesh = meshes::sphere(12);
    const Reduction reduction = reduce(mesh, {{"position", relative(0.02)}});
    const std::vector<float>& along_normal = reduction.vertex_errors[0].signed_error;
    EXPECT_LT(*std::min_element(along_normal.begin(), along_normal.end()), -0.02);
    EXPECT_LT(*std::max_element(along_normal.begin(), along_normal.end()), 1e-6);
}

TEST(MapOfPropagatedErrors, IsEmpty) {
    Options options;
    options.errors = ErrorAccounting::propagated;
    const Reduction reduction = guarantee::reduced(meshes::sphere(6), guarantee::percent(3, 3), options);
    EXPECT_TRUE(reduction.map.images.empty());
    EXPECT_TRUE(reduction.map.crossings.empty());
    EXPECT_TRUE(reduction.vertex_errors.empty());
}

Step over(std::uint32_t a, std::uint32_t b) { return {certificate::edge(a, b), 0, false}; }
Step at(std::uint32_t vertex) { return {{0, 0}, vertex, true}; }

TEST(MapCertificate, TellsATearFromAFilling) {
    using certificate::can_be_filled;
    EXPECT_TRUE(can_be_filled({}));
    EXPECT_TRUE(can_be_filled({at(1), at(2), at(3)}));
    EXPECT_TRUE(can_be_filled({over(1, 2), over(1, 2)}));
    EXPECT_TRUE(can_be_filled({over(1, 2), over(2, 3), over(2, 3), over(1, 2)}));
    EXPECT_TRUE(can_be_filled({over(1, 2), at(3), over(1, 2)}));
    EXPECT_TRUE(can_be_filled({at(1), over(1, 2), over(1, 3)})) << "around a kept vertex";
    EXPECT_FALSE(can_be_filled({over(1, 2), over(2, 3), over(3, 1)})) << "around a vertex that is not there";
    EXPECT_FALSE(can_be_filled({over(1, 2)}));
    EXPECT_FALSE(can_be_filled({at(3), over(1, 2)}));
}

TEST(MapCertificate, FindsWhatIsTamperedWith) {
    Mesh mesh = meshes::jittered(meshes::plane(12, 12), 0.01, 1);
    const Reduction sound = guarantee::reduced(mesh, {{"position", relative(0.02)}});
    ASSERT_THAT(Certificate(mesh, sound).faults(), testing::IsEmpty());
    ASSERT_GT(sound.map.crossings.size(), 10U);

    Reduction torn = sound;
    torn.map.crossings.erase(torn.map.crossings.begin() + 5);
    EXPECT_THAT(Certificate(mesh, torn).faults(), testing::Not(testing::IsEmpty())) << "a crossing is missing";

    Reduction beyond = sound;
    beyond.map.crossings[3].t = 1.01;
    EXPECT_THAT(Certificate(mesh, beyond).faults(), testing::Not(testing::IsEmpty()));

    Reduction swapped = sound;
    std::swap(swapped.mesh.triangles.front(), swapped.mesh.triangles.back());
    EXPECT_THAT(Certificate(mesh, swapped).faults(), testing::Not(testing::IsEmpty()));

    Reduction moved = sound;
    for (std::uint32_t v = 0; v < moved.map.images.size(); ++v) {
        glm::dvec3& w = moved.map.images[v].barycentric;
        if (std::min({w.x, w.y, w.z}) > 0.1) std::swap(w.x, w.y);
    }
    EXPECT_THAT(Certificate(mesh, moved).faults(), testing::IsEmpty()) << "still continuous";
    EXPECT_GT(Certificate(mesh, moved).largest_errors()[0], sound.report.variables[0].bound.absolute);
}

} // namespace
