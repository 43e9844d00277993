// Nearest points in joint space, against grids and against what must hold at a minimum.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include <glm/vec2.hpp>
#include <gtest/gtest.h>

#include "errors/tracked/joint_space.hpp"
#include "meshbound/bounds.hpp"
#include "meshes/random.hpp"
#include "meshes/shapes.hpp"
#include "metric/bounded_rows.hpp"
#include "metric/rows.hpp"

namespace {

using namespace meshbound;

constexpr int cells = 60;
/// Rounding of sums of squares of rows of size 1.
constexpr double rounding = 1e-12;

/// Four rows of position and `scalars` more numbers, each bounded by 1.
Rows random_rows(meshes::Random& random, int scalars, const std::vector<glm::dvec3>& points) {
    Mesh mesh = meshes::from_points(points, {{0, 1, 2}, {1, 3, 2}});
    for (int i = 0; i < scalars; ++i) {
        std::vector<double> values(4);
        for (double& value : values) value = random.uniform(-1, 1);
        mesh.variables.push_back({"scalar " + std::to_string(i), 1, values});
    }
    std::vector<ResolvedBound> resolved;
    EXPECT_TRUE(resolve_bounds(mesh, {{"*", absolute(1)}}, resolved).ok());
    return Rows(mesh, resolved);
}

std::vector<glm::dvec3> random_points(meshes::Random& random) {
    std::vector<glm::dvec3> points(4);
    for (glm::dvec3& point : points) point = {random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
    return points;
}

PlaneProducts products(const BoundedRows& rows, const auto& lanes) {
    LaneProducts sum;
    for (int i = 0; i < rows.lanes(); ++i) sum.add(lanes(i));
    return sum.total();
}

template <class Try>
void for_each_case(const Try& attempt) {
    meshes::Random random(11);
    for (int n = 0; n < 200; ++n) {
        std::vector<glm::dvec3> points = random_points(random);
        if (n % 5 == 1) points[1] = points[0];                         // an edge without extent
        if (n % 5 == 2) points[2] = 0.5 * points[0] + 0.5 * points[1]; // corners on a line
        const int scalars = n % 5 == 1 || n % 5 == 2 ? 0 : static_cast<int>(random.below(4));
        const Rows all = random_rows(random, scalars, points);
        const BoundedRows rows(all);
        attempt(rows);
    }
}

TEST(JointSpace, NoPointOfATriangleIsNearerThanTheNearest) {
    int inside = 0;
    for_each_case([&](const BoundedRows& rows) {
        const PlaneProducts to_row = products(rows, within({rows[0], rows[1], rows[2]}, rows[3]));
        const glm::dvec2 nearest = nearest_in_triangle(to_row);
        ASSERT_GE(nearest.x, 0);
        ASSERT_GE(nearest.y, 0);
        ASSERT_LE(nearest.x + nearest.y, 1 + rounding);
        const double least = to_row.squared_at(nearest);
        for (int i = 0; i <= cells; ++i)
            for (int j = 0; i + j <= cells; ++j)
                EXPECT_LE(least, to_row.squared_at({double(i) / cells, double(j) / cells}) + rounding);
        inside += nearest.x > 0 && nearest.y > 0 && nearest.x + nearest.y < 1;
    });
    EXPECT_GT(inside, 20);
}

TEST(JointSpace, TwoSegmentsAreComparedWhereTheyAreNear) {
    int better = 0;
    for_each_case([&](const BoundedRows& rows) {
        const PlaneProducts both = products_of(rows, {rows[0], rows[1]}, {rows[2], rows[3]});
        const double low = 0.25, high = 0.75;
        const glm::dvec2 chosen = nearest_parameters(both, low, high);
        ASSERT_GE(chosen.x, low);
        ASSERT_LE(chosen.x, high);
        ASSERT_GE(chosen.y, 0);
        ASSERT_LE(chosen.y, 1);
        // For its x no other y is better, and it beats the middles: any parameters are valid, these are meant to be good.
        for (int j = 0; j <= cells; ++j)
            EXPECT_LE(both.squared_at(chosen), both.squared_at({chosen.x, double(j) / cells}) + rounding);
        double best = both.squared_at(chosen);
        for (int i = 0; i <= cells; ++i)
            for (int j = 0; j <= cells; ++j)
                best = std::min(best, both.squared_at({low + (high - low) * i / cells, double(j) / cells}));
        better += best < both.squared_at(chosen) - rounding;
    });
    // Clamping one at a time misses the constrained minimum now and then, seldom.
    EXPECT_LT(better, 20);
}

TEST(JointSpace, ProductsAreThoseOfTheRows) {
    for_each_case([](const BoundedRows& rows) {
        const PlaneProducts both = products_of(rows, {rows[0], rows[1]}, {rows[2], rows[3]});
        for (const glm::dvec2& at : {glm::dvec2(0), glm::dvec2(1, 0), glm::dvec2(0.3, 0.9)}) {
            double squared = 0;
            for (int i = 0; i < rows.lanes(); ++i) {
                const auto point = [&](int row) { return BoundedRows::lane(rows[static_cast<std::uint32_t>(row)], i); };
                const Lane difference =
                    point(0) + at.x * (point(1) - point(0)) - point(2) - at.y * (point(3) - point(2));
                squared += difference[0] * difference[0] + difference[1] * difference[1];
            }
            EXPECT_NEAR(both.squared_at(at), squared, rounding);
        }
    });
}

TEST(JointSpace, NoiseIsNoDistance) {
    EXPECT_EQ(without_noise(1e-16, 1), 0);
    EXPECT_EQ(without_noise(-1e-16, 1), 0);
    EXPECT_EQ(without_noise(1e-13, 1), 1e-13);
    EXPECT_EQ(without_noise(0, 0), 0);
}

} // namespace
