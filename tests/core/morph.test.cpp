// Between two levels of detail the morph leads from the one surface to the other without a jump or a crack, and keeps the
// bounds of the coarser one all the way.

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "guarantee.hpp"
#include "meshes/defects.hpp"
#include "meshes/fields.hpp"
#include "meshes/gallery.hpp"
#include "meshes/shapes.hpp"
#include "meshes/topology.hpp"
#include "meshes/variations.hpp"
#include "modes.hpp"
#include "samples.hpp"

namespace {

using namespace meshbound;

/// A morph has a small multiple of the finer level's triangles: this many times them, and a few where there are few.
constexpr double size_factor = 4;

/// One step of a list of levels: from a finer surface to the next.
struct Step {
    const Mesh& original;
    const Mesh& finer;
    const Reduction& coarser;
    MappedSurfaces surfaces;
    const Reduction* finer_level; ///< null where the finer surface is the original
};

double area(const Mesh& mesh) {
    double sum = 0;
    for (const glm::uvec3& t : mesh.triangles) {
        const glm::dvec3 a = meshes::point(mesh, t.x), b = meshes::point(mesh, t.y), c = meshes::point(mesh, t.z);
        sum += glm::length(glm::cross(b - a, c - a)) / 2;
    }
    return sum;
}

VariableView variable(const Mesh& mesh, std::size_t i) { return variable_of(mesh, i); }

/// Rounding of values in the mesh's precision, as a share of a variable's extent.
double rounding(const Mesh& mesh) {
    const bool doubles = std::holds_alternative<std::vector<double>>(mesh.position.values);
    return doubles ? 1e-12 : 1e-6;
}

/// Bounds of a smaller share of the extent are too fine for the judge.
constexpr double finest_judged = 1e-9;

class MorphTest : public testing::TestWithParam<Mode> {
protected:
    /// All steps from the original through the levels.
    template <class Visit>
    void for_each_step(const Mesh& mesh, const std::vector<Bounds>& bounds, const Visit& visit) const {
        Levels levels;
        const Status status = reduce_levels(mesh, bounds, {GetParam().options(), true}, levels);
        ASSERT_TRUE(status.ok()) << status.message;
        for (std::size_t i = 0; i < levels.levels.size(); ++i) {
            SCOPED_TRACE("to level " + std::to_string(i));
            const Reduction& coarser = levels.levels[i];
            if (i == 0) {
                visit(Step{mesh, mesh, coarser, {mesh, coarser}, nullptr});
            } else {
                const Mesh& finer = levels.levels[i - 1].mesh;
                visit(Step{mesh, finer, coarser, {finer, coarser.mesh, levels.maps[i - 1]}, &levels.levels[i - 1]});
            }
        }
    }

    static Morph morph_of(const Step& step) {
        Morph morph;
        const Status status = make_morph(step.surfaces, morph);
        EXPECT_TRUE(status.ok()) << status.message;
        return morph;
    }

    static void expect_everything(const Step& step, std::size_t samples) {
        const Morph morph = morph_of(step);
        expect_corners(step, morph);
        expect_size(step, morph);
        expect_both_levels_covered(step, morph);
        expect_no_cracks(step, morph);
        expect_judge_agrees(step, morph, samples);
    }

    /// The vertices of both levels are there, bit for bit, and every crossing.
    static void expect_corners(const Step& step, const Morph& morph) {
        const std::size_t vertices = vertex_count(step.finer), crossings = step.surfaces.map.crossings.size();
        ASSERT_EQ(morph.finer.variables.size(), 1 + step.finer.variables.size());
        ASSERT_EQ(morph.coarser.variables.size(), morph.finer.variables.size());
        std::vector<std::uint32_t> first;
        for (std::uint32_t v = 0; v < vertices; ++v) first.push_back(v);
        for (std::size_t i = 0; i < morph.finer.variables.size(); ++i) {
            const std::size_t count =
                (vertices + crossings) * static_cast<std::size_t>(morph.finer.variables[i].components);
            EXPECT_EQ(value_count(morph.finer.variables[i]), count);
            EXPECT_EQ(value_count(morph.coarser.variables[i]), count);
            EXPECT_TRUE(guarantee::same_bits(gather(morph.finer.variables[i], first), variable(step.finer, i)));
            EXPECT_TRUE(guarantee::same_bits(gather(morph.coarser.variables[i], step.surfaces.vertices),
                                             variable(step.coarser.mesh, i)));
        }
        expect_places(step.finer, morph, morph.finer);
        expect_places(step.coarser.mesh, morph, morph.coarser);
        std::set<std::uint32_t> used, in_use;
        for (const glm::uvec3& t : morph.triangles) used.insert({t.x, t.y, t.z});
        for (const glm::uvec3& t : step.finer.triangles) in_use.insert({t.x, t.y, t.z});
        for (const std::uint32_t vertex : in_use) EXPECT_TRUE(used.count(vertex)) << "vertex " << vertex;
        for (std::uint32_t n = 0; n < crossings; ++n)
            EXPECT_TRUE(used.count(static_cast<std::uint32_t>(vertices) + n)) << "crossing " << n;
    }

    /// Each corner of a triangle lies in the level's triangle that its triangle lies in.
    static void expect_places(const Mesh& level, const Morph& morph, const MorphEnd& end) {
        ASSERT_EQ(end.triangles.size(), morph.triangles.size());
        for (std::size_t n = 0; n < morph.triangles.size(); ++n) {
            const glm::uvec3& host = level.triangles.at(end.triangles[n]);
            for (int corner = 0; corner < 3; ++corner) {
                const MorphPoint& place = end.points.at(morph.triangles[n][corner]);
                double inside = 0;
                for (int i = 0; i < 3; ++i) {
                    ASSERT_GE(place.weights[i], 0);
                    for (int k = 0; k < 3; ++k)
                        if (place.weights[i] > 0 && place.vertices[i] == host[k]) inside += place.weights[i];
                }
                ASSERT_NEAR(inside, 1, 1e-12) << "triangle " << n;
            }
        }
    }

    static void expect_size(const Step& step, const Morph& morph) {
        EXPECT_LE(static_cast<double>(morph.triangles.size()),
                  size_factor * static_cast<double>(step.finer.triangles.size()) + 20);
        EXPECT_LE(morph.folded_triangles, morph.triangles.size());
    }

    /// At 0 it is the finer surface and at 1 the coarser one: neither has a point that the other has not.
    static void expect_both_levels_covered(const Step& step, const Morph& morph) {
        const Mesh start = morphed(morph, 0), end = morphed(morph, 1);
        EXPECT_NEAR(area(start), area(step.finer), rounding(step.finer) * area(step.finer));
        EXPECT_GE(area(end), area(step.coarser.mesh) * (1 - rounding(step.finer)));
        if (morph.folded_triangles == 0) {
            EXPECT_NEAR(area(end), area(step.coarser.mesh), 10 * rounding(step.finer) * area(step.coarser.mesh));
        }
        std::vector<double> hairs;
        for (const VariableReport& report : step.coarser.report.variables)
            hairs.push_back(std::max(10 * rounding(step.finer), finest_judged) *
                                (report.bound.extent + report.bound.magnitude) +
                            1e-30);
        EXPECT_LE(judge::judge(step.finer, start, hairs, 5'000).ratio(), 1);
        EXPECT_LE(judge::judge(step.coarser.mesh, end, hairs, 5'000).ratio(), 1);
    }

    /// The triangles of the morph are joined as those of the finer level are.
    static void expect_no_cracks(const Step& step, const Morph& morph) {
        Mesh joined;
        joined.triangles = morph.triangles;
        joined.position.values = morph.finer.variables[0].values;
        const meshes::Topology before = meshes::topology(step.finer), after = meshes::topology(joined);
        EXPECT_EQ(after.components, before.components);
        EXPECT_EQ(after.boundary_loops, before.boundary_loops);
        if (before.non_manifold_edges > 0 || before.discordant_edges > 0) return;
        EXPECT_EQ(after.euler, before.euler);
        EXPECT_EQ(after.discordant_edges, 0U);
    }

    /// All the way within the coarser level's bounds of the original.
    static void expect_judge_agrees(const Step& step, const Morph& morph, std::size_t samples) {
        expect_within(guarantee::absolute_bounds(step.coarser), step, morph, samples);
    }

    static void expect_within(const std::vector<double>& bounds, const Step& step, const Morph& morph,
                              std::size_t samples) {
        for (const double share : {0.0, 0.25, 0.5, 0.75, 1.0}) {
            SCOPED_TRACE(share);
            const Mesh between = morphed(morph, share);
            const meshbound::Judgement surface = judge::judge(step.original, between, bounds, samples);
            EXPECT_LE(surface.ratio(), 1 + 10 * guarantee::hair) << surface;
            const meshbound::Judgement boundary = judge::judge_boundary(step.original, between, bounds, samples / 10);
            EXPECT_LE(boundary.ratio(), 1 + 10 * guarantee::hair) << "boundary; " << boundary;
        }
    }
};
INSTANTIATE_TEST_SUITE_P(TrackedModes, MorphTest, testing::ValuesIn(tracked_modes()), mode_name);

TEST_P(MorphTest, LeadsFromLevelToLevelOverEveryKindOfSurface) {
    for (const meshes::Exhibit& exhibit : meshes::gallery()) {
        SCOPED_TRACE(exhibit.name);
        for_each_step(exhibit.mesh, {guarantee::percent(1, 3), guarantee::percent(2, 6), guarantee::percent(4, 12)},
                      [](const Step& step) { expect_everything(step, 4'000); });
    }
}

/// Where a bound does not rise, the way may leave it, by a few percent as a rule, but never the bounds of both levels together.
TEST_P(MorphTest, StaysWithinBothLevelsTogetherWhereABoundDoesNotRise) {
    for (const meshes::Exhibit& exhibit : meshes::gallery()) {
        SCOPED_TRACE(exhibit.name);
        for_each_step(exhibit.mesh, {guarantee::percent(1, 3), guarantee::percent(1.2, 3), guarantee::percent(5, 3)},
                      [](const Step& step) {
                          std::vector<double> bounds = guarantee::absolute_bounds(step.coarser);
                          if (step.finer_level) {
                              const std::vector<double> finer = guarantee::absolute_bounds(*step.finer_level);
                              for (std::size_t i = 0; i < bounds.size(); ++i) bounds[i] += finer[i];
                          }
                          expect_within(bounds, step, morph_of(step), 4'000);
                      });
    }
}

TEST_P(MorphTest, LeadsFromLevelToLevelOverSamples) {
    for_each_sample(15'000, [this](const Mesh& mesh) {
        for_each_step(mesh, {guarantee::percent(1, 3), guarantee::percent(3, 9)},
                      [](const Step& step) { expect_everything(step, 10'000); });
    });
}

TEST_P(MorphTest, HoldsTogetherOddSurfaces) {
    std::size_t number = 0;
    for (const Mesh& odd : meshes::odd_surfaces()) {
        SCOPED_TRACE(number++);
        for_each_step(odd, {guarantee::percent(1, 3), guarantee::percent(5, 10)}, [](const Step& step) {
            const Morph morph = morph_of(step);
            expect_corners(step, morph);
            expect_size(step, morph);
            expect_no_cracks(step, morph);
        });
    }
}

TEST_P(MorphTest, TravelsNoFartherThanTheBoundsOfBothLevelsTogether) {
    for (const meshes::Exhibit& exhibit : meshes::gallery()) {
        SCOPED_TRACE(exhibit.name);
        for_each_step(exhibit.mesh, {guarantee::percent(1, 3), guarantee::percent(3, 9)}, [](const Step& step) {
            const Morph morph = morph_of(step);
            for (std::size_t i = 0; i < morph.finer.variables.size(); ++i) {
                const int components = morph.finer.variables[i].components;
                const ResolvedBound& bound = step.coarser.report.variables[i].bound;
                const double finer = step.finer_level ? step.finer_level->report.variables[i].bound.absolute : 0;
                for (std::size_t corner = 0;
                     corner * static_cast<std::size_t>(components) < value_count(morph.finer.variables[i]); ++corner) {
                    double square = 0;
                    for (int c = 0; c < components; ++c) {
                        const double d = value_at(morph.finer.variables[i], corner, c) -
                                         value_at(morph.coarser.variables[i], corner, c);
                        square += d * d;
                    }
                    ASSERT_LE(std::sqrt(square), finer + bound.absolute + rounding(step.finer) * bound.extent);
                }
            }
        });
    }
}

TEST(Morph, IsLinearBetweenItsEnds) {
    const Mesh mesh = meshes::gallery()[0].mesh;
    const Reduction reduction = guarantee::reduced(mesh, guarantee::percent(3, 9));
    Morph morph;
    ASSERT_TRUE(make_morph({mesh, reduction}, morph).ok());
    const Mesh start = morphed(morph, 0), middle = morphed(morph, 0.5), end = morphed(morph, 1);
    EXPECT_TRUE(guarantee::same_bits(start.position, morph.finer.variables[0]));
    EXPECT_TRUE(guarantee::same_bits(end.position, morph.coarser.variables[0]));
    for (std::size_t i = 0; i < vertex_count(start); ++i)
        for (int c = 0; c < 3; ++c)
            ASSERT_NEAR(value_at(middle.position, i, c),
                        (value_at(start.position, i, c) + value_at(end.position, i, c)) / 2, 1e-6);
}

TEST(Morph, AsLaidOutOfAPlaneHasNoFolds) {
    Mesh mesh = meshes::jittered(meshes::plane(20, 20), 0.01, 3);
    meshes::add_usual_fields(mesh);
    LevelOptions options;
    options.reduction.optimize_vertex_images = options.reduction.optimize_edge_crossings = false;
    options.maps = true;
    Levels levels;
    ASSERT_TRUE(reduce_levels(mesh, {guarantee::percent(1, 3), guarantee::percent(2, 6)}, options, levels).ok());
    Morph morph;
    ASSERT_TRUE(make_morph({levels.levels[0].mesh, levels.levels[1].mesh, levels.maps[0]}, morph).ok());
    EXPECT_EQ(morph.folded_triangles, 0U);
    EXPECT_EQ(morph.folded_share, 0);
}

TEST(Morph, OfPropagatedErrorsIsEmpty) {
    Options options;
    options.errors = ErrorAccounting::propagated;
    const Mesh mesh = meshes::sphere(6);
    Morph morph;
    const Reduction reduction = guarantee::reduced(mesh, guarantee::percent(3, 3), options);
    ASSERT_TRUE(make_morph({mesh, reduction}, morph).ok());
    EXPECT_TRUE(morph.triangles.empty());
    EXPECT_TRUE(morph.finer.variables.empty());
}

} // namespace
