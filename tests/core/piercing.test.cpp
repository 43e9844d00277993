// Lobes that pass near each other (§3.2.3): a reduction must not make one pierce the other.

#include <gtest/gtest.h>

#include "meshes/near_lobes.hpp"
#include "promise.hpp"
#include "self_intersection/self_intersections.hpp"

namespace {

using namespace meshbound;

/// Wider than the gaps, so that piercing is within the bounds.
Bounds tempting() { return {{"position", relative(0.02)}}; }

class NearLobesTest : public testing::TestWithParam<meshes::Exhibit> {};
INSTANTIATE_TEST_SUITE_P(NearLobes, NearLobesTest, testing::ValuesIn(meshes::near_lobes()));

TEST_P(NearLobesTest, AreWholeAndTempting) {
    const Mesh& mesh = GetParam().mesh;
    EXPECT_TRUE(judge::self_intersections(mesh).empty());
    EXPECT_FALSE(judge::self_intersections(promise::reduced(mesh, tempting()).mesh).empty());
}

} // namespace
