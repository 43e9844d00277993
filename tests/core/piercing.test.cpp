// Lobes that pass near each other (§3.2.3): a reduction must not make one pierce the other.

#include <array>
#include <set>
#include <string>
#include <vector>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "geometry/triangle_intersection.hpp"
#include "guarantee.hpp"
#include "meshes/gallery.hpp"
#include "meshes/near_lobes.hpp"
#include "meshes/random.hpp"
#include "meshes/shapes.hpp"
#include "meshes/variations.hpp"
#include "modes.hpp"
#include "self_intersection/self_intersections.hpp"

namespace {

using namespace meshbound;

/// Wider than the gaps, so that piercing is within the bounds.
Bounds tempting() { return {{"position", relative(0.02)}}; }

Options refusing(Options options) {
    options.refuse_piercing = true;
    return options;
}

class NearLobesTest : public testing::TestWithParam<meshes::Exhibit> {};
INSTANTIATE_TEST_SUITE_P(NearLobes, NearLobesTest, testing::ValuesIn(meshes::near_lobes()));

TEST_P(NearLobesTest, AreWholeAndTempting) {
    const Mesh& mesh = GetParam().mesh;
    EXPECT_TRUE(judge::self_intersections(mesh).empty());
    EXPECT_FALSE(judge::self_intersections(guarantee::reduced(mesh, tempting()).mesh).empty());
}

TEST_P(NearLobesTest, DoNotPierceWhereThatIsRefused) {
    const Mesh& mesh = GetParam().mesh;
    for (const Mode& mode : modes()) {
        SCOPED_TRACE(mode.name);
        const Reduction reduction = guarantee::reduced(mesh, tempting(), refusing(mode.options()));
        EXPECT_EQ(judge::self_intersections(reduction.mesh).size(), 0U);
        EXPECT_LT(reduction.mesh.triangles.size(), mesh.triangles.size() / 2);
        guarantee::expect_everything(mesh, reduction);
    }
}

TEST_P(NearLobesTest, DoNotPierceInAnyLevel) {
    LevelOptions options;
    options.reduction.refuse_piercing = true;
    options.maps = true;
    Levels levels;
    const Status status =
        reduce_levels(GetParam().mesh, {guarantee::percent(0.5, 1), guarantee::percent(2, 4)}, options, levels);
    ASSERT_TRUE(status.ok()) << status.message;
    for (const Reduction& level : levels.levels) EXPECT_EQ(judge::self_intersections(level.mesh).size(), 0U);
}

class PiercingTest : public ModeTest {};
EVERY_MODE(PiercingTest);

TEST_P(PiercingTest, DoesNotComeAboutOnAnyKindOfSurface) {
    for (const meshes::Exhibit& exhibit : meshes::gallery()) {
        SCOPED_TRACE(exhibit.name);
        if (!judge::self_intersections(exhibit.mesh).empty()) continue;
        for (const double percent : {1.0, 8.0}) {
            const Reduction reduction =
                guarantee::reduced(exhibit.mesh, guarantee::percent(percent, 50), refusing(GetParam().options()));
            EXPECT_EQ(judge::self_intersections(reduction.mesh).size(), 0U) << percent;
        }
    }
}

TEST_P(PiercingTest, DoesNotComeAboutOnRandomSurfaces) {
    for (std::uint64_t seed = 1; seed <= 12; ++seed) {
        SCOPED_TRACE(seed);
        const Mesh whole = meshes::noisy_sphere(8, 0.02 * static_cast<double>(seed), seed); // each ray meets it once
        const Mesh mesh = seed % 2 == 0 ? meshes::in_single(whole) : whole;
        ASSERT_TRUE(judge::self_intersections(mesh).empty());
        const Reduction reduction =
            guarantee::reduced(mesh, {{"position", relative(0.05)}}, refusing(GetParam().options()));
        EXPECT_EQ(judge::self_intersections(reduction.mesh).size(), 0U);
    }
}

/// The points of a triangle, which tell it from the others of its mesh.
std::array<glm::dvec3, 3> points(const Mesh& mesh, std::size_t triangle) {
    const glm::uvec3& t = mesh.triangles[triangle];
    return {meshes::point(mesh, t.x), meshes::point(mesh, t.y), meshes::point(mesh, t.z)};
}

bool has_triangle(const Mesh& mesh, std::array<glm::dvec3, 3> wanted) {
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const auto found = points(mesh, t);
        for (std::size_t turn = 0; turn < 3; ++turn)
            if (wanted == std::array{found[turn], found[(turn + 1) % 3], found[(turn + 2) % 3]}) return true;
    }
    return false;
}

/// What pierced before may stay, but nothing new pierces.
TEST_P(PiercingTest, StaysWhereItWas) {
    const auto sheet = [](double slope) {
        return meshes::grid(
            20, 20, [slope](double u, double v) { return glm::dvec3(u, v, slope * (u - 0.513) + 0.01 * v * v); });
    };
    const Mesh mesh = meshes::joined(sheet(0.3), meshes::flipped(sheet(-0.2), 60, 1));
    ASSERT_FALSE(judge::self_intersections(mesh).empty());
    const Reduction reduction = guarantee::reduced(mesh, tempting(), refusing(GetParam().options()));
    EXPECT_LT(reduction.mesh.triangles.size(), mesh.triangles.size());
    const judge::TrianglePairs pairs = judge::self_intersections(reduction.mesh);
    for (const auto& [one, other] : pairs)
        for (const std::size_t triangle : {one, other})
            EXPECT_TRUE(has_triangle(mesh, points(reduction.mesh, triangle)));
}

/// A sheet with a bump, and a tetrahedron, which cannot be reduced, in the bump.
TEST_P(PiercingTest, IsCountedWhereItHoldsBack) {
    const Mesh sheet =
        meshes::grid(2, 2, [](double u, double v) { return glm::dvec3(u, v, u == 0.5 && v == 0.5 ? 0.1 : 0); });
    const Mesh tetrahedron =
        meshes::from_points({{0.5, 0.5, 0.05}, {0.48, 0.48, -0.1}, {0.52, 0.48, -0.1}, {0.5, 0.52, -0.1}},
                            {{0, 2, 1}, {0, 3, 2}, {0, 1, 3}, {1, 2, 3}});
    const Mesh mesh = meshes::joined(sheet, tetrahedron);
    ASSERT_TRUE(judge::self_intersections(mesh).empty());
    const Bounds bounds = {{"position", absolute(0.2)}};
    const Reduction careless = guarantee::reduced(mesh, bounds, GetParam().options());
    EXPECT_FALSE(judge::self_intersections(careless.mesh).empty());
    const Reduction careful = guarantee::reduced(mesh, bounds, refusing(GetParam().options()));
    EXPECT_TRUE(judge::self_intersections(careful.mesh).empty());
    EXPECT_GE(careful.report.refused.piercing, 1U);
}

/// A seam doubles vertices, not places: its two sides meet there as neighbours do, and may be reduced together.
TEST_P(PiercingTest, IsNotSeenInASeam) {
    const Mesh left = meshes::plane(8, 8);
    const Mesh right = meshes::mapped(left, [](glm::dvec3 p) { return p + glm::dvec3(1, 0, 0); });
    const Reduction reduction =
        guarantee::reduced(meshes::joined(left, right), tempting(), refusing(GetParam().options()));
    EXPECT_EQ(reduction.mesh.triangles.size(), 4U);
}

/// Coordinates of a coarse lattice, so that triangles touch in every way there is; in thirds, so that they are rounded.
glm::dvec3 lattice_point(meshes::Random& random) {
    const auto coordinate = [&] { return std::floor(random.uniform(0, 4)) / 3; };
    const double x = coordinate(), y = coordinate();
    return {x, y, coordinate()};
}

bool has_area(const std::array<glm::dvec3, 3>& t) {
    return glm::length(glm::cross(t[1] - t[0], t[2] - t[0])) > 1e-6; // lattice triangles have more or, rounded, less
}

/// The two triangles as a mesh that the judge takes: of an edge in common the second runs the other way.
bool judge_sees_contact(const std::vector<glm::dvec3>& points, const glm::uvec3& one, const glm::uvec3& other) {
    try {
        return !judge::self_intersections(meshes::from_points(points, {one, other})).empty();
    } catch (const std::invalid_argument&) {
        return !judge::self_intersections(meshes::from_points(points, {one, {other.x, other.z, other.y}})).empty();
    }
}

TEST(TriangleContactTest, AgreesWithTheJudge) {
    meshes::Random random(1);
    std::array<int, 3> contacts{}, misses{}; // by corners in common
    for (int round = 0; round < 30'000; ++round) {
        const auto common = static_cast<std::uint32_t>(round % 3);
        std::vector<glm::dvec3> points(6 - common);
        for (glm::dvec3& point : points) point = lattice_point(random);
        const glm::uvec3 one(0, 1, 2);
        const glm::uvec3 other = common == 0   ? glm::uvec3(3, 4, 5)
                                 : common == 1 ? glm::uvec3(2, 3, 4)
                                               : glm::uvec3(2, 1, 3);
        const auto placed = [&](const glm::uvec3& t) {
            return SpatialTriangle{{t.x, t.y, t.z}, {points[t.x], points[t.y], points[t.z]}};
        };
        std::set<std::array<double, 3>> distinct;
        for (const glm::dvec3& p : points) distinct.insert({p.x, p.y, p.z});
        if (distinct.size() < points.size() || !has_area(placed(one).points) || !has_area(placed(other).points))
            continue;
        const bool seen = judge_sees_contact(points, one, other);
        ++(seen ? contacts : misses)[common];
        ASSERT_EQ(intersect_beyond_shared(placed(one), placed(other)), seen) << "round " << round;
        ASSERT_EQ(intersect_beyond_shared(placed(other), placed(one)), seen) << "round " << round;
    }
    for (const std::size_t common : {0U, 1U, 2U}) {
        EXPECT_GT(contacts[common], 100) << common;
        EXPECT_GT(misses[common], 100) << common;
    }
}

} // namespace
