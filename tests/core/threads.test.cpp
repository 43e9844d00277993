// Any number of threads gives the same bytes, and what they give gives the guarantee.

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "guarantee.hpp"
#include "meshes/defects.hpp"
#include "meshes/fields.hpp"
#include "meshes/near_lobes.hpp"
#include "meshes/shapes.hpp"
#include "meshes/variations.hpp"
#include "modes.hpp"
#include "reduction/patches.hpp"
#include "util/thread_pool.hpp"

namespace {

using namespace meshbound;

struct Case {
    std::string name;
    Mesh mesh;
    Bounds bounds;
};

/// Large enough that rounds are cut. On the noisy sphere the first sweep finds little, so that the last one, too, has enough
/// to be cut; the sheets meet in non-manifold edges, beside which no patch may go.
std::vector<Case> cases() {
    const auto with_fields = [](Mesh mesh) {
        meshes::add_usual_fields(mesh);
        return mesh;
    };
    const auto scaled = [](const Mesh& mesh) { return meshes::mapped(mesh, [](glm::dvec3 p) { return 0.1 * p; }); };
    return {{"torus", with_fields(meshes::torus(160, 80)), guarantee::percent(1, 3)},
            {"terrain", with_fields(meshes::terrain(7, 3)), guarantee::percent(2, 6)},
            {"noisy sphere", meshes::noisy_sphere(64, 0.01, 7), {{"position", relative(0.02)}}},
            {"three sheets", with_fields(scaled(meshes::three_sheets(60))), guarantee::percent(1, 3)}};
}

Reduction reduced_by(unsigned threads, const Case& given, Options options) {
    options.threads = threads;
    return guarantee::reduced(given.mesh, given.bounds, options);
}

void expect_same(const TriangleErrors& one, const TriangleErrors& other) {
    EXPECT_EQ(one.ratio, other.ratio);
    EXPECT_EQ(one.largest, other.largest);
    EXPECT_EQ(one.lowest, other.lowest);
    EXPECT_EQ(one.highest, other.highest);
}

void expect_same(const SurfaceMap& one, const SurfaceMap& other) {
    ASSERT_EQ(one.images.size(), other.images.size());
    ASSERT_EQ(one.crossings.size(), other.crossings.size());
    for (std::size_t i = 0; i < one.images.size(); ++i) {
        ASSERT_EQ(one.images[i].triangle, other.images[i].triangle);
        ASSERT_EQ(one.images[i].barycentric, other.images[i].barycentric);
    }
    for (std::size_t i = 0; i < one.crossings.size(); ++i) {
        const MapCrossing &a = one.crossings[i], &b = other.crossings[i];
        ASSERT_EQ(a.original, b.original);
        ASSERT_EQ(a.reduced, b.reduced);
        ASSERT_EQ(a.s, b.s);
        ASSERT_EQ(a.t, b.t);
        ASSERT_EQ(a.rightward, b.rightward);
    }
}

void expect_same(const Reduction& one, const Reduction& other) {
    EXPECT_TRUE(guarantee::same_bits(one.mesh, other.mesh));
    EXPECT_EQ(one.vertices, other.vertices);
    ASSERT_EQ(one.triangle_errors.size(), other.triangle_errors.size());
    for (std::size_t i = 0; i < one.triangle_errors.size(); ++i)
        expect_same(one.triangle_errors[i], other.triangle_errors[i]);
    ASSERT_EQ(one.vertex_errors.size(), other.vertex_errors.size());
    for (std::size_t i = 0; i < one.vertex_errors.size(); ++i)
        EXPECT_EQ(one.vertex_errors[i].error, other.vertex_errors[i].error);
    expect_same(one.map, other.map);
    for (std::size_t i = 0; i < one.report.variables.size(); ++i) {
        EXPECT_EQ(one.report.variables[i].error, other.report.variables[i].error);
        EXPECT_EQ(one.report.variables[i].refused, other.report.variables[i].refused);
    }
    EXPECT_EQ(one.report.folded_cells, other.report.folded_cells);
}

class ThreadsTest : public ModeTest {};
EVERY_MODE(ThreadsTest);

TEST_P(ThreadsTest, AnyNumberGivesTheSameBytes) {
    for (const Case& given : cases()) {
        SCOPED_TRACE(given.name);
        const Reduction alone = reduced_by(1, given, GetParam().options());
        EXPECT_LT(alone.mesh.triangles.size(), given.mesh.triangles.size());
        for (const unsigned threads : {2U, 3U, 8U}) {
            SCOPED_TRACE(threads);
            expect_same(alone, reduced_by(threads, given, GetParam().options()));
        }
    }
}

TEST_P(ThreadsTest, TheirResultGivesTheGuarantee) {
    for (const Case& given : cases()) {
        SCOPED_TRACE(given.name);
        guarantee::expect_everything(given.mesh, reduced_by(3, given, GetParam().options()), 20'000);
    }
}

TEST_P(ThreadsTest, ProgressNeverFallsAndComesFromTheCaller) {
    const Case given = cases().front();
    Options options = GetParam().options();
    options.threads = 3;
    const std::thread::id caller = std::this_thread::get_id();
    std::vector<double> values;
    Reduction reduction;
    const Status status = reduce(given.mesh, given.bounds, options, reduction, [&](double value) {
        EXPECT_EQ(std::this_thread::get_id(), caller);
        values.push_back(value);
        return true;
    });
    EXPECT_TRUE(status.ok());
    EXPECT_GT(values.size(), 10U);
    EXPECT_TRUE(std::is_sorted(values.begin(), values.end()));
    EXPECT_EQ(values.back(), 1);
}

TEST_P(ThreadsTest, CancelledTheyLeaveAValidResult) {
    const Case given = cases().front();
    Options options = GetParam().options();
    options.threads = 3;
    for (const double at : {0.05, 0.2, 0.4}) {
        SCOPED_TRACE(at);
        Reduction reduction;
        const Status status =
            reduce(given.mesh, given.bounds, options, reduction, [at](double value) { return value < at; });
        EXPECT_TRUE(status.ok());
        EXPECT_EQ(reduction.report.termination, Termination::cancelled);
        guarantee::expect_everything(given.mesh, reduction, 2'000);
    }
}

/// Patches that many lobes run through, in the last sweep too.
TEST(ThreadsOfPiercingTest, AnyNumberGivesTheSameBytes) {
    const Case given{"nested spheres", meshes::nested_spheres(40, 0.01), {{"position", relative(0.02)}}};
    Options options;
    options.refuse_piercing = true;
    const Reduction alone = reduced_by(1, given, options);
    EXPECT_GT(alone.report.refused.piercing, 0U);
    for (const unsigned threads : {2U, 5U}) expect_same(alone, reduced_by(threads, given, options));
}

/// Labels, a seam, bounds that vary and locks at once, with and without piercing.
TEST(ThreadsOfEverythingKeptTest, AnyNumberGivesTheSameBytes) {
    const Mesh plain = meshes::terrain(7, 5);
    Mesh mesh = meshes::joined(meshes::cut(plain, [](glm::dvec3 p) { return p.x < 0.5; }),
                               meshes::cut(plain, [](glm::dvec3 p) { return !(p.x < 0.5); }));
    meshes::add_scalar(mesh, "fineness", [](glm::dvec3 p) { return 0.1 + p.y; });
    for (const glm::uvec3& t : mesh.triangles) mesh.regions.push_back(meshes::point(mesh, t.x).y < 0.4 ? 1 : 2);
    const Case given{"terrain", mesh, {{"position", relative(0.02)}}};
    Options options;
    options.bound_multiplier = "fineness";
    options.locked_boxes = {{{0.1, 0.1, -9}, {0.2, 0.2, 9}}};
    for (const bool refuse : {false, true}) {
        options.refuse_piercing = refuse;
        const Reduction alone = reduced_by(1, given, options);
        EXPECT_LT(alone.mesh.triangles.size(), mesh.triangles.size() / 2);
        const Reduction together = reduced_by(4, given, options);
        expect_same(alone, together);
        EXPECT_EQ(alone.mesh.regions, together.mesh.regions);
    }
}

TEST(ThreadsOfLevelsTest, AnyNumberGivesTheSameLevelsAndMorphs) {
    const Case given = cases().front();
    const auto levels_by = [&](unsigned threads) {
        LevelOptions options;
        options.reduction.threads = threads;
        options.morphs = true;
        Levels levels;
        EXPECT_TRUE(reduce_levels(given.mesh, {given.bounds, guarantee::percent(3, 6)}, options, levels).ok());
        return levels;
    };
    const Levels alone = levels_by(1), together = levels_by(3);
    ASSERT_EQ(alone.levels.size(), together.levels.size());
    for (std::size_t i = 0; i < alone.levels.size(); ++i) {
        SCOPED_TRACE(i);
        expect_same(alone.levels[i], together.levels[i]);
        EXPECT_EQ(alone.morphs[i].triangles, together.morphs[i].triangles);
    }
    ASSERT_EQ(alone.maps.size(), together.maps.size());
    for (std::size_t i = 0; i < alone.maps.size(); ++i) expect_same(alone.maps[i].map, together.maps[i].map);
}

TEST(ThreadPoolTest, DoesEachTaskOnce) {
    ThreadPool pool(4);
    for (const std::size_t tasks : {0U, 1U, 3U, 1000U}) {
        std::vector<std::atomic<int>> done(tasks);
        pool.run(tasks, [&](std::size_t member, std::size_t task) {
            EXPECT_LT(member, pool.size());
            ++done[task];
        });
        EXPECT_TRUE(std::all_of(done.begin(), done.end(), [](const auto& times) { return times == 1; }));
    }
}

TEST(ThreadPoolTest, PassesOnAnExceptionAndGoesOn) {
    ThreadPool pool(3);
    const auto fail = [](std::size_t, std::size_t task) {
        if (task == 5) throw std::runtime_error("task 5");
    };
    EXPECT_THROW(pool.run(100, fail), std::runtime_error);
    std::atomic<int> done{0};
    pool.run(10, [&](std::size_t, std::size_t) { ++done; });
    EXPECT_EQ(done, 10);
}

/// That patch alone in which it lies.
void expect_one_holds(const Patches& patches, const glm::dvec3& position) {
    for (std::size_t patch = 0; patch < patches.count(); ++patch)
        EXPECT_EQ(patches.contains(patch, position), patch == patches.patch_of(position));
}

TEST(PatchesTest, HoldAboutEquallyMany) {
    const Mesh mesh = meshes::noisy_sphere(40, 0.1, 1);
    std::vector<ResolvedBound> bounds;
    ASSERT_TRUE(resolve_bounds(mesh, {{"position", relative(0.01)}}, bounds).ok());
    const Rows rows(mesh, bounds);
    std::vector<std::uint32_t> vertices(vertex_count(mesh));
    for (std::uint32_t v = 0; v < vertices.size(); ++v) vertices[v] = v;
    for (const std::uint32_t shift : {0U, 1U, 2U}) {
        const Patches patches(rows, vertices, 4, shift);
        std::vector<std::size_t> count(patches.count());
        for (const std::uint32_t v : vertices) {
            ++count[patches.patch_of(rows.position(v))];
            expect_one_holds(patches, rows.position(v));
        }
        EXPECT_GT(*std::min_element(count.begin(), count.end()), vertices.size() / 32);
        EXPECT_LT(*std::max_element(count.begin(), count.end()), vertices.size() / 8);
    }
}

TEST(PatchesTest, ManyVerticesAtOnePlaceLieInOnePatch) {
    const Mesh mesh = meshes::mapped(meshes::plane(40, 40), [](glm::dvec3) { return glm::dvec3(1); });
    std::vector<ResolvedBound> bounds;
    ASSERT_TRUE(resolve_bounds(mesh, {{"position", absolute(1)}}, bounds).ok());
    const Rows rows(mesh, bounds);
    const std::vector<std::uint32_t> vertices(1000, 0);
    const Patches patches(rows, vertices, 3, 0);
    for (std::uint32_t v = 0; v < vertex_count(mesh); ++v)
        EXPECT_EQ(patches.patch_of(rows.position(v)), patches.patch_of(rows.position(0)));
    expect_one_holds(patches, rows.position(0)); // below, at and above where all cuts are
    for (const double x : {0.0, 0.5, 2.0}) expect_one_holds(patches, glm::dvec3(x));
}

} // namespace
