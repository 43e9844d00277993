// Identifiers are carried along: no bound for all variables is about them, and one of their own is.

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "guarantee.hpp"
#include "meshbound/meshbound.hpp"
#include "meshes/fields.hpp"
#include "meshes/shapes.hpp"

namespace {

using namespace meshbound;

/// A plane whose points are numbered at random, as a partition leaves them.
Mesh numbered_plane(VariableKind kind) {
    Mesh mesh = meshes::plane(12, 12);
    meshes::add_scalar(mesh, "heat", [](const glm::dvec3& p) { return p.x; });
    std::vector<double> ids(vertex_count(mesh));
    for (std::size_t i = 0; i < ids.size(); ++i) ids[i] = static_cast<double>(i * 7919 % ids.size());
    mesh.variables.push_back({"GlobalNodeID", 1, ids, kind});
    return mesh;
}

const Bounds one_percent = {{"*", relative(0.01)}};

TEST(Identifiers, ABoundForAllIsNotAboutThem) {
    std::vector<ResolvedBound> resolved;
    ASSERT_TRUE(resolve_bounds(numbered_plane(VariableKind::identifier), one_percent, resolved).ok());
    EXPECT_TRUE(std::isfinite(resolved[1].absolute));
    EXPECT_TRUE(std::isinf(resolved[2].absolute));
    EXPECT_EQ(resolved[2].given.kind, Bound::Kind::free);
    EXPECT_GT(resolved[2].extent, 0) << "measured all the same";
}

TEST(Identifiers, TheirOwnNameBoundsThem) {
    const Mesh mesh = numbered_plane(VariableKind::identifier);
    for (const Bounds& bounds : {Bounds{{"GlobalNodeID", absolute(2)}, {"*", relative(0.01)}},
                                 Bounds{{"*", relative(0.01)}, {"GlobalNodeID", absolute(2)}}}) {
        std::vector<ResolvedBound> resolved;
        ASSERT_TRUE(resolve_bounds(mesh, bounds, resolved).ok());
        EXPECT_EQ(resolved[2].absolute, 2);
    }
}

TEST(Identifiers, HoldNothingBackAndGoOutAsTheyCame) {
    const Mesh mesh = numbered_plane(VariableKind::identifier);
    const Reduction free = guarantee::reduced(mesh, one_percent);
    const Reduction bounded = guarantee::reduced(numbered_plane(VariableKind::quantity), one_percent);
    EXPECT_LE(free.report.triangles_after, 4U);
    EXPECT_GT(bounded.report.triangles_after, 100U) << "the same numbers as a quantity";
    EXPECT_TRUE(guarantee::same_bits(free.mesh.variables[1], gather(mesh.variables[1], free.vertices)));
}

TEST(Identifiers, StayIdentifiersInResultReportLevelsAndMorphs) {
    const Mesh mesh = numbered_plane(VariableKind::identifier);
    LevelOptions options;
    options.morphs = true;
    Levels levels;
    ASSERT_TRUE(reduce_levels(mesh, {{{"*", relative(0.01)}}, {{"*", relative(0.02)}}}, options, levels).ok());
    for (const Reduction& level : levels.levels) {
        EXPECT_EQ(level.mesh.variables[0].kind, VariableKind::quantity);
        EXPECT_EQ(level.mesh.variables[1].kind, VariableKind::identifier);
        EXPECT_EQ(level.report.variables[1].kind, VariableKind::quantity);
        EXPECT_EQ(level.report.variables[2].kind, VariableKind::identifier);
    }
    for (const Morph& morph : levels.morphs)
        for (const MorphEnd* end : {&morph.finer, &morph.coarser})
            EXPECT_EQ(end->variables[2].kind, VariableKind::identifier);
}

TEST(Identifiers, AreFreeOnwardFromACheckpoint) {
    Reduction reduction, onward;
    Checkpoint checkpoint;
    ASSERT_TRUE(reduce(numbered_plane(VariableKind::identifier), one_percent, {}, reduction, {}, &checkpoint).ok());
    ASSERT_TRUE(resume_reduction(checkpoint, {{"*", relative(0.02)}}, {}, onward).ok());
    EXPECT_TRUE(std::isinf(onward.report.variables[2].bound.absolute));
    EXPECT_EQ(onward.report.variables[2].kind, VariableKind::identifier);
    EXPECT_LE(onward.report.triangles_after, 4U);
}

} // namespace
