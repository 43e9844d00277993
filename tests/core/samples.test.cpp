// The promise over surfaces from simulations and measurements, where the build or the user has some.

#include <string>

#include <gtest/gtest.h>

#include "meshes/ply.hpp"
#include "modes.hpp"
#include "promise.hpp"

namespace {

using namespace meshbound;

/// Larger samples are judged at one bound only.
constexpr std::size_t large_sample = 40'000;

class Samples : public ModeTest {
protected:
    static void expect_promise(double geometry, double variables, std::size_t most_triangles) {
        if (meshes::sample_files().empty())
            GTEST_SKIP() << "no samples; the build makes some, MESHBOUND_DATA names more";
        for (const std::string& file : meshes::sample_files()) {
            SCOPED_TRACE(file);
            const Mesh mesh = meshes::read_ply(file);
            if (mesh.triangles.size() > most_triangles) continue;
            const Reduction reduction =
                promise::reduced(mesh, promise::percent(geometry, variables), GetParam().options());
            promise::expect_everything(mesh, reduction, 50'000);
        }
    }
};
EVERY_MODE(Samples);

TEST_P(Samples, KeepThePromiseAtTightBounds) { expect_promise(0.1, 1, large_sample); }
TEST_P(Samples, KeepThePromiseAtUsualBounds) { expect_promise(1, 3, SIZE_MAX); }
TEST_P(Samples, KeepThePromiseAtLooseBounds) { expect_promise(6, 6, large_sample); }

TEST_P(Samples, LoseMostOfTheirTriangles) {
    for (const std::string& file : meshes::sample_files()) {
        SCOPED_TRACE(file);
        const Mesh mesh = meshes::read_ply(file);
        if (mesh.triangles.size() > large_sample) continue;
        const Reduction reduction = promise::reduced(mesh, promise::percent(6, 6), GetParam().options());
        EXPECT_LT(reduction.mesh.triangles.size(), mesh.triangles.size() / 2);
    }
}

} // namespace
