// Levels of detail nest bit for bit, and each gives its guarantee against the original as if it were reduced alone.

#include <algorithm>
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
#include "modes.hpp"
#include "samples.hpp"

namespace {

using namespace meshbound;
using certificate::Certificate;

const std::vector<Bounds> doubling = {guarantee::percent(1, 3), guarantee::percent(2, 6), guarantee::percent(4, 12)};
const std::vector<Bounds> in_space_alone = {guarantee::percent(0.5, 3), guarantee::percent(2, 3),
                                            guarantee::percent(6, 3)};
const std::vector<Bounds> to_free = {{{"position", relative(0.01)}, {"*", relative(0.02)}},
                                     {{"position", relative(0.02)}, {"wave", relative(0.02)}}};

class LevelsTest : public ModeTest {
protected:
    Levels levels_of(const Mesh& mesh, const std::vector<Bounds>& bounds, bool links = false) const {
        Levels levels;
        const Status status = reduce_levels(mesh, bounds, {GetParam().options(), links}, levels);
        EXPECT_TRUE(status.ok()) << status.message;
        EXPECT_EQ(levels.levels.size(), bounds.size());
        return levels;
    }

    static void expect_nested(const Levels& levels) {
        for (std::size_t i = 1; i < levels.levels.size(); ++i) {
            const std::vector<std::uint32_t>&finer = levels.levels[i - 1].vertices,
                  &coarser = levels.levels[i].vertices;
            EXPECT_TRUE(std::includes(finer.begin(), finer.end(), coarser.begin(), coarser.end()));
            EXPECT_LE(levels.levels[i].mesh.triangles.size(), levels.levels[i - 1].mesh.triangles.size());
        }
    }

    static void expect_all_guarantees(const Mesh& mesh, const Levels& levels, std::size_t samples) {
        expect_nested(levels);
        for (std::size_t i = 0; i < levels.levels.size(); ++i) {
            SCOPED_TRACE("level " + std::to_string(i));
            guarantee::expect_everything(mesh, levels.levels[i], samples);
            EXPECT_LE(guarantee::largest_ratio(levels.levels[i]), 1);
        }
    }

    /// The map of each level proves its errors against the original, with no trust in how it came about.
    static void expect_proofs(const Mesh& mesh, const Levels& levels) {
        for (const Reduction& level : levels.levels) {
            if (level.map.images.empty()) continue;
            const Certificate certificate(mesh, level);
            EXPECT_THAT(certificate.faults(), testing::IsEmpty());
            expect_errors(certificate.largest_errors(), level);
        }
    }

    static void expect_errors(const std::vector<double>& errors, const Reduction& level) {
        for (std::size_t i = 0; i < errors.size(); ++i) {
            const VariableReport& variable = level.report.variables[i];
            EXPECT_LE(errors[i], variable.bound.absolute * (1 + guarantee::hair)) << variable.name;
            EXPECT_NEAR(errors[i], variable.error,
                        1e-6 * variable.error + 1e-12 * (variable.bound.extent + variable.bound.magnitude));
        }
    }
};
EVERY_MODE(LevelsTest);

TEST_P(LevelsTest, NestAndGiveTheirGuaranteesOverEveryKindOfSurface) {
    for (const meshes::Exhibit& exhibit : meshes::gallery())
        for (const std::vector<Bounds>& bounds : {doubling, in_space_alone, to_free}) {
            SCOPED_TRACE(exhibit.name);
            const Levels levels = levels_of(exhibit.mesh, bounds);
            expect_all_guarantees(exhibit.mesh, levels, 10'000);
        }
}

TEST_P(LevelsTest, GetCoarser) {
    for (const meshes::Exhibit& exhibit : meshes::gallery()) {
        SCOPED_TRACE(exhibit.name);
        const Levels levels = levels_of(exhibit.mesh, doubling);
        for (std::size_t i = 1; i < doubling.size(); ++i)
            EXPECT_LT(levels.levels[i].mesh.triangles.size(), levels.levels[i - 1].mesh.triangles.size());
    }
}

TEST_P(LevelsTest, GiveTheirGuaranteesOverSamples) {
    for_each_sample(15'000, [this](const Mesh& mesh) {
        const Levels levels = levels_of(mesh, doubling, true);
        expect_all_guarantees(mesh, levels, 20'000);
        expect_proofs(mesh, levels);
    });
}

TEST_P(LevelsTest, ProveTheirErrorsAgainstTheOriginal) {
    for (const meshes::Exhibit& exhibit : meshes::gallery()) {
        SCOPED_TRACE(exhibit.name);
        expect_proofs(exhibit.mesh, levels_of(exhibit.mesh, doubling));
    }
}

TEST_P(LevelsTest, NestOnOddSurfaces) {
    std::size_t number = 0;
    for (const Mesh& odd : meshes::odd_surfaces()) {
        SCOPED_TRACE(number++);
        const Levels levels = levels_of(odd, doubling, true);
        expect_nested(levels);
        expect_proofs(odd, levels);
    }
}

TEST_P(LevelsTest, BeginWithTheReductionToTheFirstBounds) {
    const Mesh mesh = meshes::gallery()[4].mesh;
    const Reduction alone = guarantee::reduced(mesh, doubling[0], GetParam().options());
    for (const bool links : {false, true}) {
        const Reduction first = levels_of(mesh, doubling, links).levels.front();
        EXPECT_TRUE(guarantee::same_bits(first.mesh, alone.mesh));
        EXPECT_EQ(first.vertices, alone.vertices);
        EXPECT_EQ(first.report.cells, alone.report.cells);
        for (std::size_t i = 0; i < alone.triangle_errors.size(); ++i)
            EXPECT_EQ(first.triangle_errors[i].largest, alone.triangle_errors[i].largest);
    }
}

TEST_P(LevelsTest, LeaveAboutAsFewTrianglesAsAReductionFromScratch) {
    std::size_t continued = 0, scratch = 0;
    for (const meshes::Exhibit& exhibit : meshes::gallery()) {
        continued += levels_of(exhibit.mesh, doubling).levels.back().mesh.triangles.size();
        scratch += guarantee::reduced(exhibit.mesh, doubling.back(), GetParam().options()).mesh.triangles.size();
    }
    EXPECT_LT(static_cast<double>(continued), 1.1 * static_cast<double>(scratch));
}

TEST_P(LevelsTest, ReportEachLevelAgainstTheOriginal) {
    const Mesh mesh = meshes::gallery()[4].mesh;
    for (const Reduction& level : levels_of(mesh, to_free).levels) {
        EXPECT_EQ(level.report.triangles_before, mesh.triangles.size());
        EXPECT_EQ(level.report.triangles_after, level.mesh.triangles.size());
        EXPECT_EQ(level.report.vertices_after, level.vertices.size());
        EXPECT_EQ(level.report.termination, Termination::finished);
        EXPECT_EQ(level.triangle_errors.front().largest.size(), level.mesh.triangles.size());
        std::size_t reasons = level.report.refused.non_manifold + level.report.refused.locked +
                              level.report.refused.ring + level.report.refused.topology + level.report.refused.fold;
        for (const VariableReport& variable : level.report.variables) reasons += variable.refused;
        EXPECT_EQ(reasons, level.vertices.size());
    }
}

TEST_P(LevelsTest, LinkNeighboursWhereAskedTo) {
    for (const meshes::Exhibit& exhibit : meshes::gallery()) {
        SCOPED_TRACE(exhibit.name);
        EXPECT_TRUE(levels_of(exhibit.mesh, doubling).maps.empty());
        const Levels levels = levels_of(exhibit.mesh, doubling, true);
        const bool tracked = GetParam().options().errors == ErrorAccounting::tracked;
        ASSERT_EQ(levels.maps.size(), tracked ? doubling.size() - 1 : 0);
        expect_all_guarantees(exhibit.mesh, levels, 5'000);
    }
}

TEST_P(LevelsTest, LinksAreMapsWithinTheBoundsOfBothLevelsTogether) {
    for (const meshes::Exhibit& exhibit : meshes::gallery())
        for (const std::vector<Bounds>& bounds : {doubling, in_space_alone, to_free}) {
            SCOPED_TRACE(exhibit.name);
            const Levels levels = levels_of(exhibit.mesh, bounds, true);
            for (std::size_t i = 0; i < levels.maps.size(); ++i) {
                const Reduction &finer = levels.levels[i], &coarser = levels.levels[i + 1];
                const LevelMap& link = levels.maps[i];
                ASSERT_EQ(link.vertices.size(), coarser.vertices.size());
                for (std::size_t v = 0; v < link.vertices.size(); ++v)
                    ASSERT_EQ(finer.vertices[link.vertices[v]], coarser.vertices[v]);
                Reduction step;
                step.mesh = coarser.mesh;
                step.vertices = link.vertices;
                step.map = link.map;
                const Certificate certificate(finer.mesh, step);
                EXPECT_THAT(certificate.faults(), testing::IsEmpty());
                step.report = coarser.report;
                for (std::size_t n = 0; n < link.errors.size(); ++n) {
                    step.report.variables[n].error = link.errors[n];
                    step.report.variables[n].bound.absolute += finer.report.variables[n].bound.absolute;
                }
                expect_errors(certificate.largest_errors(), step);
            }
        }
}

TEST_P(LevelsTest, MakeTheMorphsAskedFor) {
    const Mesh mesh = meshes::gallery()[4].mesh;
    Levels levels;
    ASSERT_TRUE(reduce_levels(mesh, doubling, {GetParam().options(), false, true}, levels).ok());
    if (GetParam().options().errors == ErrorAccounting::propagated) {
        EXPECT_TRUE(levels.morphs.empty());
        return;
    }
    ASSERT_EQ(levels.morphs.size(), doubling.size());
    ASSERT_EQ(levels.maps.size(), doubling.size() - 1);
    for (std::size_t i = 0; i < doubling.size(); ++i) {
        Morph morph;
        const MappedSurfaces surfaces =
            i == 0 ? MappedSurfaces{mesh, levels.levels[0]}
                   : MappedSurfaces{levels.levels[i - 1].mesh, levels.levels[i].mesh, levels.maps[i - 1]};
        ASSERT_TRUE(make_morph(surfaces, morph).ok());
        EXPECT_EQ(levels.morphs[i].triangles, morph.triangles);
        EXPECT_TRUE(guarantee::same_bits(levels.morphs[i].finer.variables[0], morph.finer.variables[0]));
        EXPECT_TRUE(guarantee::same_bits(levels.morphs[i].coarser.variables[1], morph.coarser.variables[1]));
    }
}

TEST_P(LevelsTest, RefuseListsThatDoNotGoFromFineToCoarse) {
    const Mesh mesh = meshes::gallery()[0].mesh;
    struct Case {
        std::vector<Bounds> bounds;
        Fault fault;
        std::string variable;
        std::optional<std::size_t> level;
    };
    const Bounds one = guarantee::percent(1, 3), two = guarantee::percent(2, 6);
    const std::vector<Case> cases = {
        {{}, Fault::bad_levels, "", {}},
        {{two, one}, Fault::bad_levels, "position", 1},
        {{one, two, {{"position", relative(0.02)}, {"*", relative(0.06)}, {"wave", relative(0.05)}}},
         Fault::bad_levels,
         "wave",
         2},
        {{one, one}, Fault::bad_levels, "", 1},
        {{{{"position", relative(0.01)}}, one}, Fault::bad_levels, "linear", 1}, // was free
        {{one, {{"position", relative(-1)}}}, Fault::bad_bound, "position", {}},
        {{one, {{"presure", relative(1)}}}, Fault::unknown_variable, "presure", {}},
    };
    for (const Case& bad : cases) {
        Levels levels;
        levels.levels.resize(7);
        const Status status = reduce_levels(mesh, bad.bounds, {GetParam().options()}, levels);
        SCOPED_TRACE(status.message);
        EXPECT_EQ(status.fault, bad.fault);
        EXPECT_EQ(status.variable, bad.variable);
        EXPECT_EQ(status.index, bad.level);
        EXPECT_FALSE(status.message.empty());
        EXPECT_EQ(levels.levels.size(), 7U) << "touched";
    }
}

TEST_P(LevelsTest, NameTheLevelAtFault) {
    Levels levels;
    const Mesh mesh = meshes::gallery()[0].mesh;
    const Status falls = reduce_levels(mesh, {guarantee::percent(2, 6), guarantee::percent(1, 6)}, {}, levels);
    EXPECT_THAT(falls.message, testing::AllOf(testing::HasSubstr("“position”"), testing::HasSubstr("level 1"),
                                              testing::HasSubstr("level 2")));
    const Status bad = reduce_levels(mesh, {guarantee::percent(2, 6), guarantee::percent(3, -1)}, {}, levels);
    EXPECT_THAT(bad.message, testing::HasSubstr("level 2"));
}

class LevelsProgress : public LevelsTest {
protected:
    Mesh mesh = [] {
        Mesh torus = meshes::torus(70, 36);
        meshes::add_scalar(torus, "wave", meshes::wave_field);
        return torus;
    }();
};
EVERY_MODE(LevelsProgress);

TEST_P(LevelsProgress, RisesToOneOverAllLevels) {
    std::vector<double> values;
    Levels levels;
    ASSERT_TRUE(reduce_levels(mesh, doubling, {GetParam().options(), true, true}, levels, [&values](double value) {
                    values.push_back(value);
                    return true;
                }).ok());
    EXPECT_TRUE(std::is_sorted(values.begin(), values.end()));
    EXPECT_LT(values.front(), 0.5);
    EXPECT_EQ(values.back(), 1);
    EXPECT_EQ(std::count(values.begin(), values.end(), 1), 1);
}

TEST_P(LevelsProgress, CancelledLeavesTheLevelsSoFar) {
    LevelOptions options{GetParam().options(), true, true};
    options.reduction.threads = 1; // of several, how often the caller's reports is chance (tests/core/threads.test.cpp)
    std::size_t calls = 0;
    Levels all;
    ASSERT_TRUE(reduce_levels(mesh, doubling, options, all, [&calls](double) { return ++calls > 0; }).ok());
    for (std::size_t part = 0; part < 8; ++part) {
        const std::size_t last_call = part * (calls - 2) / 7;
        SCOPED_TRACE(last_call);
        std::size_t call = 0;
        Levels levels;
        EXPECT_TRUE(reduce_levels(mesh, doubling, options, levels, [&](double) { return call++ < last_call; }).ok());
        EXPECT_EQ(call, last_call + 1) << "asked again after it was told to stop";
        if (levels.levels.empty()) continue; // before the first began
        ASSERT_LE(levels.levels.size(), doubling.size());
        EXPECT_EQ(levels.levels.back().report.termination, Termination::cancelled);
        for (std::size_t i = 0; i + 1 < levels.levels.size(); ++i) {
            EXPECT_EQ(levels.levels[i].report.termination, Termination::finished);
            EXPECT_TRUE(guarantee::same_bits(levels.levels[i].mesh, all.levels[i].mesh));
        }
        EXPECT_LT(levels.maps.size(), levels.levels.size());
        EXPECT_LT(levels.morphs.size(), levels.levels.size());
        expect_all_guarantees(mesh, levels, 2'000);
    }
}

} // namespace
