// Whatever map a reduction or a level of detail gives out, all that takes maps takes it: the check, the segmentation, the morph
// and the certificate.

#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "guarantee.hpp"
#include "map_certificate.hpp"
#include "modes.hpp"
#include "samples.hpp"

namespace {

using namespace meshbound;

/// Of position, in percent of its extent; variables have three times as much.
const std::vector<double> all_bounds = {0.1, 0.2, 0.5, 1, 2, 3, 5, 10, 20};
/// Large samples are looked at with a tight, a usual and a loose one, and their maps are not certified, which takes long.
const std::vector<double> few_bounds = {0.1, 1, 20};
constexpr std::size_t large_sample = 40'000;

bool is_large(const Mesh& mesh) { return mesh.triangles.size() > large_sample; }

class OwnMaps : public testing::TestWithParam<Mode> {
protected:
    static std::vector<double> bounds_for(const Mesh& mesh) { return is_large(mesh) ? few_bounds : all_bounds; }

    static void expect_taken(const MappedSurfaces& surfaces) {
        Segmentation segmentation;
        const Status segmented = segment(surfaces, segmentation);
        EXPECT_TRUE(segmented.ok()) << segmented.message;
        EXPECT_GE(segmentation.cells.size(), surfaces.reduced.triangles.size());
        Morph morph;
        const Status morphed = make_morph(surfaces, morph);
        EXPECT_TRUE(morphed.ok()) << morphed.message;
        EXPECT_EQ(morph.triangles.size(), segmentation.pieces.size());
    }

    static void expect_certified(const Mesh& mesh, const Reduction& reduction) {
        if (is_large(mesh)) return;
        EXPECT_THAT(certificate::Certificate(mesh, reduction).faults(), testing::IsEmpty());
    }
};
INSTANTIATE_TEST_SUITE_P(TrackedModes, OwnMaps, testing::ValuesIn(tracked_modes()), mode_name);

TEST_P(OwnMaps, AreTakenOfOneResult) {
    for_each_sample(SIZE_MAX, [this](const Mesh& mesh) {
        for (const double percent : bounds_for(mesh)) {
            SCOPED_TRACE(percent);
            const Reduction reduction =
                guarantee::reduced(mesh, guarantee::percent(percent, 3 * percent), GetParam().options());
            expect_taken({mesh, reduction});
            expect_certified(mesh, reduction);
        }
    });
}

TEST_P(OwnMaps, AreTakenOfFourLevels) {
    for_each_sample(SIZE_MAX, [this](const Mesh& mesh) {
        for (const double percent : bounds_for(mesh)) {
            SCOPED_TRACE(percent);
            std::vector<Bounds> bounds;
            for (const double times : {1, 2, 4, 8})
                bounds.push_back(guarantee::percent(times * percent, 3 * times * percent));
            Levels levels;
            const Status status = reduce_levels(mesh, bounds, {GetParam().options(), true}, levels);
            ASSERT_TRUE(status.ok()) << status.message;
            expect_taken({mesh, levels.levels[0]});
            for (std::size_t i = 0; i < levels.maps.size(); ++i) {
                SCOPED_TRACE("to level " + std::to_string(i + 1));
                const Mesh &finer = levels.levels[i].mesh, &coarser = levels.levels[i + 1].mesh;
                expect_taken({finer, coarser, levels.maps[i]});
                Reduction between;
                between.mesh = coarser;
                between.vertices = levels.maps[i].vertices;
                between.map = levels.maps[i].map;
                expect_certified(finer, between);
                expect_certified(mesh, levels.levels[i + 1]);
            }
        }
    });
}

} // namespace
