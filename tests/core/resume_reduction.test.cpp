// A reduction hands out the surface that it passes on its way, and from there another one goes on within the bounds.

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "guarantee.hpp"
#include "meshes/defects.hpp"
#include "meshes/fields.hpp"
#include "meshes/gallery.hpp"
#include "meshes/random.hpp"
#include "meshes/shapes.hpp"
#include "modes.hpp"
#include "samples.hpp"

namespace {

using namespace meshbound;

const Bounds usual = guarantee::percent(1, 3);

/// "wave" alone has a bound besides position.
const Bounds partly_free = {{"position", relative(0.01)}, {"wave", relative(0.03)}};

Checkpoint checkpoint_of(const Reduction& reduction) { return {reduction.mesh, reduction.vertices, reduction.report}; }

/// The judge takes no bound of zero, nor one that is next to nothing beside the extent.
constexpr double least_share = 1e-6;

/// As a reduction within what was spent, of the least share of the extent where it is next to nothing; what is free stays free.
Reduction as_reduction(const Checkpoint& checkpoint) {
    Reduction reduction{checkpoint.mesh, checkpoint.vertices, {}, {}, {}, checkpoint.report};
    for (VariableReport& variable : reduction.report.variables) {
        if (std::isinf(variable.bound.absolute)) continue;
        variable.bound.absolute = std::max(variable.error, least_share * variable.bound.extent);
        variable.ratio = 1;
    }
    return reduction;
}

/// Two squares of regions in halves, with fields.
Mesh with_regions() {
    Mesh mesh = meshes::grid(
        24, 24, [](double u, double v) { return glm::dvec3(u, v, 0.05 * std::sin(9 * u) * std::sin(7 * v)); });
    meshes::add_usual_fields(mesh);
    for (const glm::uvec3& t : mesh.triangles) mesh.regions.push_back(meshes::point(mesh, t.x).x < 0.5 ? 3 : 7);
    return mesh;
}

Mesh usual_mesh() { return meshes::gallery()[4].mesh; }

class Onward : public ModeTest {
protected:
    Options options = GetParam().options();

    Reduction reduce(const Mesh& mesh, const Bounds& bounds, Checkpoint& checkpoint) const {
        Reduction reduction;
        const Status status = meshbound::reduce(mesh, bounds, options, reduction, {}, &checkpoint);
        EXPECT_TRUE(status.ok()) << status.message;
        return reduction;
    }

    Checkpoint passed(const Mesh& mesh, const Bounds& bounds) const {
        Checkpoint checkpoint;
        reduce(mesh, bounds, checkpoint);
        return checkpoint;
    }

    Reduction onward(const Checkpoint& checkpoint, const Bounds& bounds) const {
        Reduction reduction;
        const Status status = resume_reduction(checkpoint, bounds, options, reduction);
        EXPECT_TRUE(status.ok()) << status.message;
        return reduction;
    }

    Status refused(const Checkpoint& checkpoint, const Bounds& bounds) const {
        Reduction reduction;
        reduction.vertices = {7};
        const Status status = resume_reduction(checkpoint, bounds, options, reduction);
        EXPECT_EQ(reduction.vertices, std::vector<std::uint32_t>{7}) << "touched";
        return status;
    }
};
EVERY_MODE(Onward);

/// Every figure about a triangle, and the report, say the same.
void expect_sums(const Mesh& mesh, const Reduction& reduction) {
    EXPECT_TRUE(reduction.report.errors_are_upper_bounds);
    EXPECT_TRUE(reduction.map.images.empty());
    EXPECT_TRUE(reduction.vertex_errors.empty());
    ASSERT_EQ(reduction.triangle_errors.size(), 1 + mesh.variables.size());
    for (std::size_t i = 0; i < reduction.triangle_errors.size(); ++i) {
        const TriangleErrors& errors = reduction.triangle_errors[i];
        const VariableReport& variable = reduction.report.variables[i];
        SCOPED_TRACE(variable.name);
        ASSERT_EQ(errors.largest.size(), reduction.mesh.triangles.size());
        ASSERT_EQ(errors.ratio.size(), reduction.mesh.triangles.size());
        EXPECT_NEAR(*std::max_element(errors.largest.begin(), errors.largest.end()), variable.error,
                    1e-6 * variable.error);
        if (std::isinf(variable.bound.absolute)) {
            EXPECT_EQ(variable.ratio, 0);
            continue;
        }
        EXPECT_LE(variable.error, variable.bound.absolute);
        EXPECT_LE(*std::max_element(errors.ratio.begin(), errors.ratio.end()), 1);
        EXPECT_NEAR(variable.error / variable.bound.absolute, variable.ratio, 1e-12);
    }
}

TEST_P(Onward, HandingOutTheCheckpointChangesNothing) {
    for (const meshes::Exhibit& exhibit : meshes::gallery()) {
        SCOPED_TRACE(exhibit.name);
        Checkpoint checkpoint;
        const Reduction with = reduce(exhibit.mesh, usual, checkpoint);
        const Reduction without = guarantee::reduced(exhibit.mesh, usual, options);
        EXPECT_TRUE(guarantee::same_bits(with.mesh, without.mesh));
        EXPECT_EQ(with.vertices, without.vertices);
        EXPECT_EQ(with.report.cells, without.report.cells);
        EXPECT_FALSE(with.report.errors_are_upper_bounds);
        for (std::size_t i = 0; i < with.triangle_errors.size(); ++i)
            EXPECT_EQ(with.triangle_errors[i].largest, without.triangle_errors[i].largest);
    }
}

TEST_P(Onward, ACheckpointLiesWithinWhatItHasSpent) {
    std::size_t removed = 0;
    for (const meshes::Exhibit& exhibit : meshes::gallery())
        for (const Bounds& bounds : {usual, guarantee::percent(8, 8), partly_free}) {
            SCOPED_TRACE(exhibit.name);
            Checkpoint checkpoint;
            const Reduction result = reduce(exhibit.mesh, bounds, checkpoint);
            EXPECT_GT(checkpoint.mesh.triangles.size(), result.mesh.triangles.size());
            removed += exhibit.mesh.triangles.size() - checkpoint.mesh.triangles.size();
            EXPECT_EQ(checkpoint.report.termination, Termination::intermediate);
            for (const VariableReport& variable : checkpoint.report.variables)
                EXPECT_LE(variable.error, variable.bound.absolute / 8 * (1 + guarantee::hair)) << variable.name;
            guarantee::expect_everything(exhibit.mesh, as_reduction(checkpoint), 10'000);
        }
    EXPECT_GT(removed, 0U);
}

TEST_P(Onward, KeepsEveryBoundToTheOriginal) {
    const std::vector<Bounds> next = {usual,
                                      guarantee::percent(0.3, 1),
                                      guarantee::percent(4, 12),
                                      guarantee::percent(1, 20),
                                      {{"position", relative(0.01)}, {"wave", relative(0.05)}}};
    for (const meshes::Exhibit& exhibit : meshes::gallery()) {
        const Checkpoint checkpoint = passed(exhibit.mesh, usual);
        for (const Bounds& bounds : next) {
            SCOPED_TRACE(exhibit.name);
            const Reduction reduction = onward(checkpoint, bounds);
            guarantee::expect_everything(exhibit.mesh, reduction, 10'000);
            EXPECT_LE(guarantee::largest_ratio(reduction), 1);
            expect_sums(exhibit.mesh, reduction);
        }
    }
}

TEST_P(Onward, GoesOnFromResultsTooAndOnFromThere) {
    for (const meshes::Exhibit& exhibit : meshes::gallery()) {
        SCOPED_TRACE(exhibit.name);
        const Reduction first = guarantee::reduced(exhibit.mesh, usual, options);
        const Reduction second = onward(checkpoint_of(first), guarantee::percent(2.5, 6));
        guarantee::expect_everything(exhibit.mesh, second, 10'000);
        const Reduction third = onward(checkpoint_of(second), guarantee::percent(4, 10));
        guarantee::expect_everything(exhibit.mesh, third, 10'000);
        expect_sums(exhibit.mesh, third);
        EXPECT_LT(third.mesh.triangles.size(), first.mesh.triangles.size());
    }
}

TEST_P(Onward, KeepsTheBoundsOfWhatWasFree) {
    const Mesh mesh = usual_mesh();
    const Checkpoint checkpoint = passed(mesh, partly_free);
    const double spent = checkpoint.report.variables[1].error;
    ASSERT_EQ(checkpoint.report.variables[1].name, "linear");
    const Bounds all = {{"position", relative(0.01)}, {"wave", relative(0.03)}, {"linear", absolute(1.5 * spent)}};
    guarantee::expect_everything(mesh, onward(checkpoint, all));
    const Bounds too_fine = {{"position", relative(0.01)}, {"wave", relative(0.03)}, {"linear", absolute(0.9 * spent)}};
    EXPECT_EQ(refused(checkpoint, too_fine).variable, "linear");
}

TEST_P(Onward, GivesItsGuaranteeOverSamples) {
    for_each_sample(15'000, [this](const Mesh& mesh) {
        const Checkpoint checkpoint = passed(mesh, usual);
        for (const Bounds& bounds : {usual, guarantee::percent(3, 9)}) {
            const Reduction reduction = onward(checkpoint, bounds);
            guarantee::expect_judge_agrees(mesh, reduction);
            guarantee::expect_same_topology(mesh, reduction);
        }
    });
}

TEST_P(Onward, GivesItsGuaranteeOverOddSurfaces) {
    std::vector<Mesh> odd = meshes::odd_surfaces();
    odd.push_back(meshes::moebius_band(40, 8));
    for (std::size_t i = 0; i < odd.size(); ++i) {
        SCOPED_TRACE(i);
        const Checkpoint checkpoint = passed(odd[i], guarantee::percent(2, 6));
        const Reduction reduction = onward(checkpoint, guarantee::percent(4, 12));
        guarantee::expect_vertex_subset(odd[i], reduction);
        const meshbound::Judgement judgement =
            judge::judge(odd[i], reduction.mesh, guarantee::absolute_bounds(reduction), 10'000);
        EXPECT_LE(judgement.ratio(), 1 + guarantee::hair) << judgement;
        EXPECT_EQ(reduction.report.defects.unused_vertices, checkpoint.report.defects.unused_vertices);
        EXPECT_EQ(reduction.report.defects.zero_area_triangles, checkpoint.report.defects.zero_area_triangles);
    }
}

TEST_P(Onward, TakesRelativeBoundsFromTheExtentsOfTheOriginal) {
    const Mesh mesh = usual_mesh();
    const Reduction scratch = guarantee::reduced(mesh, guarantee::percent(4, 12), options);
    const Reduction reduction = onward(passed(mesh, usual), guarantee::percent(4, 12));
    EXPECT_EQ(guarantee::absolute_bounds(reduction), guarantee::absolute_bounds(scratch));
}

TEST_P(Onward, ReportsOnTheOriginal) {
    const Mesh mesh = with_regions();
    const Checkpoint checkpoint = passed(mesh, usual);
    const Reduction reduction = onward(checkpoint, guarantee::percent(3, 9));
    const Report& report = reduction.report;
    EXPECT_EQ(report.triangles_before, mesh.triangles.size());
    EXPECT_EQ(report.vertices_before, vertex_count(mesh));
    EXPECT_EQ(report.triangles_after, reduction.mesh.triangles.size());
    EXPECT_EQ(report.vertices_after, reduction.vertices.size());
    EXPECT_EQ(report.termination, Termination::finished);
    ASSERT_EQ(report.regions.size(), 2U);
    for (const RegionReport& region : report.regions) {
        const auto before = std::count(mesh.regions.begin(), mesh.regions.end(), region.label);
        EXPECT_EQ(region.triangles_before, static_cast<std::size_t>(before));
        EXPECT_NEAR(region.area_after / region.area_before, 1, 0.1);
    }
}

TEST_P(Onward, LeavesLittleMoreThanAReductionFromScratch) {
    std::size_t continued = 0, scratch = 0;
    for (const meshes::Exhibit& exhibit : meshes::gallery()) {
        Checkpoint checkpoint;
        scratch += reduce(exhibit.mesh, usual, checkpoint).mesh.triangles.size();
        continued += onward(checkpoint, usual).mesh.triangles.size();
    }
    EXPECT_LT(static_cast<double>(continued), 1.25 * static_cast<double>(scratch));
}

TEST_P(Onward, WhatIsLockedStays) {
    const Mesh mesh = with_regions();
    const Box box{{0.6, 0.6, -1}, {0.8, 0.8, 1}};
    options.locked = {5, 100, 311};
    options.locked_boxes = {box};
    options.locked_regions = {3};
    const Reduction reduction = onward(passed(mesh, usual), guarantee::percent(4, 12));
    const auto is_left = [&](std::uint32_t vertex) {
        return std::binary_search(reduction.vertices.begin(), reduction.vertices.end(), vertex);
    };
    for (const std::uint32_t vertex : options.locked) EXPECT_TRUE(is_left(vertex));
    std::size_t in_box = 0;
    for (std::uint32_t v = 0; v < vertex_count(mesh); ++v) {
        const glm::dvec3 p = meshes::point(mesh, v);
        if (p.x < 0.6 || p.x > 0.8 || p.y < 0.6 || p.y > 0.8) continue;
        ++in_box;
        EXPECT_TRUE(is_left(v)) << v;
    }
    EXPECT_GT(in_box, 0U);
    EXPECT_EQ(reduction.report.regions[0].triangles_after, reduction.report.regions[0].triangles_before);
    EXPECT_LT(reduction.report.regions[1].triangles_after, reduction.report.regions[1].triangles_before);
    guarantee::expect_judge_agrees(mesh, reduction);
}

TEST_P(Onward, ALockedVertexThatIsGoneIsNamed) {
    const Mesh mesh = usual_mesh();
    const Checkpoint checkpoint = passed(mesh, usual);
    std::uint32_t gone = 0;
    while (checkpoint.vertices[gone] == gone) ++gone;
    options.locked = {checkpoint.vertices[0], gone};
    const Status status = refused(checkpoint, guarantee::percent(4, 12));
    EXPECT_EQ(status.fault, Fault::bad_checkpoint);
    EXPECT_EQ(status.index, gone);
}

TEST_P(Onward, NamesTheVariableWhoseBoundIsSpent) {
    const Mesh mesh = usual_mesh();
    const Checkpoint checkpoint = passed(mesh, usual);
    const auto wave = std::find_if(checkpoint.report.variables.begin(), checkpoint.report.variables.end(),
                                   [](const VariableReport& variable) { return variable.name == "wave"; });
    ASSERT_GT(wave->error, 0);
    const Bounds tight = {{"position", relative(0.01)}, {"*", relative(0.03)}, {"wave", absolute(wave->error)}};
    const Status status = refused(checkpoint, tight);
    EXPECT_EQ(status.fault, Fault::bad_checkpoint);
    EXPECT_EQ(status.variable, "wave");
    EXPECT_THAT(status.message, testing::HasSubstr("“wave”"));
    EXPECT_EQ(refused(checkpoint, guarantee::percent(0.001, 3)).variable, "position");
}

TEST_P(Onward, RefusesACheckpointThatContradictsItself) {
    const Mesh mesh = usual_mesh();
    const Checkpoint good = passed(mesh, usual);
    const auto broken = [&](const auto& breakage) {
        Checkpoint checkpoint = good;
        breakage(checkpoint);
        return refused(checkpoint, guarantee::percent(4, 12)).fault;
    };
    EXPECT_EQ(broken([](Checkpoint& w) { w.vertices.pop_back(); }), Fault::bad_checkpoint);
    EXPECT_EQ(broken([](Checkpoint& w) { std::swap(w.vertices[0], w.vertices[1]); }), Fault::bad_checkpoint);
    EXPECT_EQ(broken([](Checkpoint& w) { w.vertices.back() = 1'000'000; }), Fault::bad_checkpoint);
    EXPECT_EQ(broken([](Checkpoint& w) { w.report.variables.pop_back(); }), Fault::bad_checkpoint);
    EXPECT_EQ(broken([](Checkpoint& w) { w.report.variables[1].name = "other"; }), Fault::bad_checkpoint);
    for (const double bad : {-1.0, std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()}) {
        EXPECT_EQ(broken([bad](Checkpoint& w) { w.report.variables[1].error = bad; }), Fault::bad_checkpoint);
        EXPECT_EQ(broken([bad](Checkpoint& w) { w.report.variables[0].bound.extent = bad; }), Fault::bad_checkpoint);
    }
    EXPECT_EQ(broken([](Checkpoint& w) { w.report.vertices_before = w.vertices.back(); }), Fault::bad_checkpoint);
    EXPECT_EQ(broken([](Checkpoint& w) { w.mesh.triangles[0].x = 1'000'000; }), Fault::bad_index);
    EXPECT_EQ(broken([](Checkpoint& w) { w.mesh.triangles.clear(); }), Fault::no_triangles);
    EXPECT_EQ(broken([](Checkpoint& w) { w = {}; }), Fault::no_triangles);
}

TEST_P(Onward, NamesTheVertexThatCannotBeOfTheOriginal) {
    const Checkpoint good = passed(usual_mesh(), usual);
    const auto broken = [&](std::size_t vertex, std::uint32_t of_original) {
        Checkpoint checkpoint = good;
        checkpoint.vertices[vertex] = of_original;
        return refused(checkpoint, guarantee::percent(4, 12));
    };
    Status status = broken(5, 1'000'000);
    EXPECT_EQ(status.index, 5U);
    EXPECT_THAT(status.message, testing::HasSubstr("said to be vertex 1000000 of the original, which has"));
    status = broken(5, good.vertices[4]);
    EXPECT_EQ(status.index, 5U);
    EXPECT_THAT(status.message, testing::HasSubstr("they must rise"));
}

/// Every number of a checkpoint's arrays in turn is anything at all.
TEST_P(Onward, WhateverIsDamagedIsRefusedOrHarmless) {
    Mesh mesh = meshes::sphere(5);
    meshes::add_usual_fields(mesh);
    const Checkpoint good = passed(mesh, usual);
    std::size_t refusals = 0;
    constexpr std::size_t rounds = 300;
    for (std::size_t seed = 0; seed < rounds; ++seed) {
        SCOPED_TRACE(seed);
        meshes::Random random(seed);
        Checkpoint checkpoint = good;
        const auto value =
            static_cast<std::uint32_t>(random.below(2) ? random.below(2 * vertex_count(mesh)) : random.next());
        switch (random.below(4)) {
        case 0: checkpoint.vertices[random.below(checkpoint.vertices.size())] = value; break;
        case 1: checkpoint.vertices.resize(value % (2 * checkpoint.vertices.size()), value); break;
        case 2: checkpoint.report.vertices_before = value; break;
        default: checkpoint.mesh.triangles[random.below(checkpoint.mesh.triangles.size())].y = value;
        }
        Reduction reduction;
        const Status status = resume_reduction(checkpoint, guarantee::percent(4, 12), options, reduction);
        refusals += !status.ok();
        if (!status.ok()) continue;
        EXPECT_EQ(reduction.vertices.size(), vertex_count(reduction.mesh));
        EXPECT_TRUE(std::is_sorted(reduction.vertices.begin(), reduction.vertices.end()));
        EXPECT_LT(reduction.vertices.back(), checkpoint.report.vertices_before);
    }
    EXPECT_GT(refusals, rounds / 4);
    EXPECT_LT(refusals, rounds);
}

TEST_P(Onward, RefusesWhatOnlyTheOriginalCanTell) {
    Mesh mesh = usual_mesh();
    meshes::add_scalar(mesh, "focus", [](glm::dvec3 p) { return 1 + p.x * p.x; });
    const Checkpoint checkpoint = passed(mesh, usual);
    const Options plain = options;
    options.bound_multiplier = "focus";
    EXPECT_EQ(refused(checkpoint, guarantee::percent(4, 12)).fault, Fault::bad_option);
    options = plain;
    options.limit_to_feature_size = true;
    EXPECT_EQ(refused(checkpoint, guarantee::percent(4, 12)).fault, Fault::bad_option);
    options = plain;
    options.drop_small_components = true;
    EXPECT_EQ(refused(checkpoint, guarantee::percent(4, 12)).fault, Fault::bad_option);
}

TEST_P(Onward, GoesOnFromACheckpointOfMultipliedBounds) {
    Mesh mesh = usual_mesh();
    meshes::add_scalar(mesh, "focus", [](glm::dvec3 p) { return 1 + p.x * p.x; });
    options.bound_multiplier = "focus";
    const Checkpoint checkpoint = passed(mesh, usual);
    options.bound_multiplier.clear();
    guarantee::expect_everything(mesh, as_reduction(checkpoint));
    guarantee::expect_everything(mesh, onward(checkpoint, guarantee::percent(3, 9)));
}

TEST_P(Onward, OneSweepPassesNoCheckpoint) {
    options.sweeps = {1};
    Reduction reduction;
    Checkpoint checkpoint;
    const Status status = meshbound::reduce(usual_mesh(), usual, options, reduction, {}, &checkpoint);
    EXPECT_EQ(status.fault, Fault::bad_option);
    EXPECT_TRUE(checkpoint.vertices.empty());
}

TEST_P(Onward, IsTheSameForAnyNumberOfThreads) {
    const Mesh mesh = meshes::gallery()[2].mesh;
    const Checkpoint checkpoint = passed(mesh, usual);
    options.threads = 1;
    const Reduction one = onward(checkpoint, guarantee::percent(3, 9));
    options.threads = 3;
    EXPECT_TRUE(guarantee::same_bits(one.mesh, onward(checkpoint, guarantee::percent(3, 9)).mesh));
}

TEST_P(Onward, LeavesACheckpointUntouchedThatWasNotReached) {
    Mesh mesh = meshes::torus(70, 36);
    meshes::add_usual_fields(mesh);
    Checkpoint checkpoint = passed(mesh, guarantee::percent(0.2, 0.5));
    checkpoint.report.feature_size = 0.125;
    const Mesh before = checkpoint.mesh;
    Reduction part;
    ASSERT_TRUE(meshbound::reduce(
                    mesh, guarantee::percent(3, 9), options, part, [](double) { return false; }, &checkpoint)
                    .ok());
    EXPECT_EQ(part.report.termination, Termination::cancelled);
    EXPECT_EQ(checkpoint.report.feature_size, 0.125);
    EXPECT_TRUE(guarantee::same_bits(checkpoint.mesh, before));
}

TEST_P(Onward, ReportsProgressAndCanBeCancelled) {
    Mesh mesh = meshes::torus(70, 36);
    meshes::add_usual_fields(mesh);
    options.threads = 1;
    const Checkpoint checkpoint = passed(mesh, guarantee::percent(0.2, 0.5));
    std::vector<double> values;
    Reduction whole;
    ASSERT_TRUE(resume_reduction(checkpoint, guarantee::percent(3, 9), options, whole, [&](double value) {
                    values.push_back(value);
                    return true;
                }).ok());
    EXPECT_TRUE(std::is_sorted(values.begin(), values.end()));
    EXPECT_EQ(std::count(values.begin(), values.end(), 1), 1);
    const auto sweeping = std::upper_bound(values.begin(), values.end(), 0.1) - values.begin();
    ASSERT_LT(values[static_cast<std::size_t>(sweeping)], 0.8) << "reports too seldom for this test";
    for (const std::size_t last : {std::size_t(1), static_cast<std::size_t>(sweeping)}) {
        std::size_t call = 0;
        Reduction part;
        ASSERT_TRUE(resume_reduction(checkpoint, guarantee::percent(3, 9), options, part, [&](double) {
                        return call++ < last;
                    }).ok());
        EXPECT_EQ(part.report.termination, Termination::cancelled);
        EXPECT_GT(part.mesh.triangles.size(), whole.mesh.triangles.size());
        EXPECT_TRUE(part.triangle_errors.empty());
        guarantee::expect_everything(mesh, part, 5'000);
    }
}

} // namespace
