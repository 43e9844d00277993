// Mapped surfaces look at meshes and maps that others own, so they take none that is gone when they are there.

#include <cstdint>
#include <type_traits>
#include <vector>

#include <gtest/gtest.h>

#include "meshbound/meshbound.hpp"

namespace {

using namespace meshbound;

template <class... Arguments>
constexpr bool takes = std::is_constructible_v<MappedSurfaces, Arguments...>;

using Kept = std::vector<std::uint32_t>;

static_assert(takes<Mesh&, Reduction&> && takes<const Mesh&, const Reduction&>);
static_assert(takes<Mesh&, Mesh&, LevelMap&> && takes<Mesh&, Mesh&, Kept&, SurfaceMap&>);
static_assert(!takes<Mesh, Reduction&> && !takes<Mesh&, Reduction> && !takes<const Mesh, Reduction&>);
static_assert(!takes<Mesh, Mesh&, LevelMap&> && !takes<Mesh&, Mesh, LevelMap&> && !takes<Mesh&, Mesh&, LevelMap>);
static_assert(!takes<Mesh, Mesh&, Kept&, SurfaceMap&> && !takes<Mesh&, Mesh, Kept&, SurfaceMap&> &&
              !takes<Mesh&, Mesh&, Kept, SurfaceMap&> && !takes<Mesh&, Mesh&, Kept&, SurfaceMap>);
static_assert(!takes<Mesh, const MappedSurfaces&> && takes<Mesh&, MappedSurfaces>);

TEST(MappedSurfaces, LookAtWhatTheyWereGiven) {
    const Mesh mesh;
    const Reduction reduction;
    const MappedSurfaces surfaces(mesh, reduction);
    EXPECT_EQ(&surfaces.original, &mesh);
    EXPECT_EQ(&surfaces.reduced, &reduction.mesh);
    EXPECT_EQ(&surfaces.vertices, &reduction.vertices);
    EXPECT_EQ(&surfaces.map, &reduction.map);
    const Mesh other;
    EXPECT_EQ(&MappedSurfaces(other, surfaces).original, &other);
}

} // namespace
