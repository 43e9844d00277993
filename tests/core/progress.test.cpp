// Progress rises from 0 to 1; a call cancelled at any time leaves a valid result.

#include <algorithm>
#include <vector>

#include <gtest/gtest.h>

#include "guarantee.hpp"
#include "meshes/fields.hpp"
#include "meshes/shapes.hpp"
#include "modes.hpp"

namespace {

using namespace meshbound;

class ProgressTest : public ModeTest {
protected:
    void SetUp() override {
        mesh = meshes::torus(70, 36);
        meshes::add_scalar(mesh, "wave", meshes::wave_field);
        meshes::add_vector(mesh, "whirl", meshes::whirl_field);
    }
    Status reduce(Reduction& reduction, const Progress& progress) const {
        Options options = GetParam().options();
        options.threads = 1; // of several, how often the caller's reports is chance (tests/core/threads.test.cpp)
        return meshbound::reduce(mesh, guarantee::percent(2, 5), options, reduction, progress);
    }
    std::vector<double> all_progress(Reduction& reduction) const {
        std::vector<double> values;
        EXPECT_TRUE(reduce(reduction, [&values](double value) {
                        values.push_back(value);
                        return true;
                    }).ok());
        return values;
    }
    Mesh mesh;
};
EVERY_MODE(ProgressTest);

TEST_P(ProgressTest, RisesToOne) {
    Reduction reduction;
    const std::vector<double> values = all_progress(reduction);
    ASSERT_GT(values.size(), 10U) << "called often";
    EXPECT_TRUE(std::is_sorted(values.begin(), values.end()));
    EXPECT_GE(values.front(), 0);
    EXPECT_LT(values.front(), 0.5);
    EXPECT_EQ(values.back(), 1);
    EXPECT_EQ(reduction.report.termination, Termination::finished);
}

TEST_P(ProgressTest, ChangesNothing) {
    Reduction with, without;
    all_progress(with);
    ASSERT_TRUE(reduce(without, {}).ok());
    EXPECT_TRUE(guarantee::same_bits(with.mesh, without.mesh));
}

TEST_P(ProgressTest, CancellingAtAnyTimeLeavesAValidResult) {
    Reduction finished;
    const std::size_t calls = all_progress(finished).size() - 1;
    for (const std::size_t part : {0, 1, 2, 3, 4, 5}) {
        const std::size_t last_call = std::min(calls - 1, part * calls / 5);
        SCOPED_TRACE(last_call);
        Reduction reduction;
        std::size_t call = 0;
        const Status status = reduce(reduction, [&](double) { return call++ < last_call; });
        EXPECT_TRUE(status.ok()) << status.message;
        EXPECT_EQ(call, last_call + 1) << "asked again after it was told to stop";
        EXPECT_EQ(reduction.report.termination, Termination::cancelled);
        EXPECT_GE(reduction.mesh.triangles.size(), finished.mesh.triangles.size());
        EXPECT_EQ(reduction.report.triangles_after, reduction.mesh.triangles.size());
        guarantee::expect_everything(mesh, reduction, 2'000);
    }
}

} // namespace
