// Angles and directions from arithmetic alone, against the platform's own functions.

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "geometry/angle.hpp"
#include "meshes/random.hpp"

namespace {

using namespace meshbound;

/// What angle.hpp guarantees.
constexpr double accuracy = 1e-13;

constexpr int many = 200000;

TEST(Angle, ArcTangentIsThatOfThePlatform) {
    meshes::Random random(1);
    for (int i = 0; i < many; ++i) {
        const double z = random.uniform(0, 1);
        ASSERT_NEAR(arc_tangent(z), std::atan(z), accuracy) << z;
    }
    EXPECT_EQ(arc_tangent(0), 0);
    EXPECT_NEAR(arc_tangent(1), pi / 4, accuracy);
}

TEST(Angle, TinyArcTangentsKeepTheirDigits) {
    for (const double z : {1e-3, 1e-8, 1e-100, 1e-300}) EXPECT_NEAR(arc_tangent(z) / std::atan(z), 1, accuracy) << z;
}

TEST(Angle, OfTheHalfPlaneIsThatOfThePlatform) {
    meshes::Random random(2);
    for (int i = 0; i < many; ++i) {
        const double x = random.uniform(-1, 1), y = random.uniform(0, 1);
        ASSERT_NEAR(half_plane_angle(x, y), std::atan2(y, x), accuracy) << x << ' ' << y;
    }
}

TEST(Angle, OfTheHalfPlaneHoldsForVectorsOfAnyShape) {
    meshes::Random random(3);
    for (int i = 0; i < many; ++i) {
        const double side = random.below(2) == 0 ? -1 : 1;
        const double x = side * std::exp2(random.uniform(-300, 300)), y = std::exp2(random.uniform(-300, 300));
        ASSERT_NEAR(half_plane_angle(x, y), std::atan2(y, x), accuracy) << x << ' ' << y;
    }
}

TEST(Angle, OfTheHalfPlaneIsRightOnTheAxesAndDiagonals) {
    EXPECT_EQ(half_plane_angle(2, 0), 0);
    EXPECT_EQ(half_plane_angle(0, 2), pi / 2);
    EXPECT_EQ(half_plane_angle(-2, 0), pi);
    EXPECT_NEAR(half_plane_angle(3, 3), pi / 4, accuracy);
    EXPECT_NEAR(half_plane_angle(-3, 3), 3 * pi / 4, accuracy);
}

TEST(Angle, OfNoVectorIsZero) {
    for (const double x : {0.0, -0.0})
        for (const double y : {0.0, -0.0}) EXPECT_EQ(half_plane_angle(x, y), 0);
}

TEST(Angle, OfTheSmallestVectorsIsRight) {
    constexpr double least = std::numeric_limits<double>::denorm_min();
    EXPECT_EQ(half_plane_angle(least, 0), 0);
    EXPECT_EQ(half_plane_angle(-least, 0), pi);
    EXPECT_EQ(half_plane_angle(0, least), pi / 2);
    EXPECT_NEAR(half_plane_angle(-least, least), 3 * pi / 4, accuracy);
}

TEST(Angle, DoesNotDependOnTheLengthOfAVector) {
    meshes::Random random(4);
    for (int i = 0; i < many; ++i) {
        const double x = random.uniform(-1, 1), y = random.uniform(0, 1), angle = half_plane_angle(x, y);
        const double power = std::ldexp(1.0, static_cast<int>(random.below(1800)) - 900);
        ASSERT_EQ(half_plane_angle(power * x, power * y), angle) << x << ' ' << y << ' ' << power;
        const double factor = std::exp2(random.uniform(-900, 900));
        ASSERT_NEAR(half_plane_angle(factor * x, factor * y), angle, accuracy) << x << ' ' << y << ' ' << factor;
    }
}

TEST(Angle, RisesAlongTheHalfCircle) {
    const auto along = [](double angle) { return half_plane_angle(std::cos(angle), std::sin(angle)); };
    double before = along(0);
    for (int i = 1; i < many; ++i) {
        const double here = along(pi * i / many);
        ASSERT_GT(here, before) << i;
        before = here;
    }
}

TEST(Angle, RisesInStepsOfItsAccuracyWhereItsFormulaChanges) {
    for (const double border : {pi / 4, pi / 2, 3 * pi / 4}) {
        double before = 0;
        for (int i = -1000; i <= 1000; ++i) {
            const double angle = border + 4 * accuracy * i;
            const double here = half_plane_angle(std::cos(angle), std::sin(angle));
            ASSERT_GT(here, before) << border << ' ' << i;
            before = here;
        }
    }
}

TEST(Angle, DirectionsAreThoseOfThePlatformAllAroundTheCircle) {
    for (int i = 0; i <= many; ++i) {
        const double angle = 2 * pi * i / many;
        const glm::dvec2 heading = unit_vector(angle);
        ASSERT_NEAR(heading.x, std::cos(angle), accuracy) << angle;
        ASSERT_NEAR(heading.y, std::sin(angle), accuracy) << angle;
        ASSERT_NEAR(glm::length(heading), 1, accuracy) << angle;
    }
    EXPECT_EQ(unit_vector(0), glm::dvec2(1, 0));
}

TEST(Angle, OfADirectionIsTheAngleThatItCameFrom) {
    meshes::Random random(5);
    for (int i = 0; i < many; ++i) {
        const double angle = random.uniform(0, pi);
        const glm::dvec2 heading = unit_vector(angle);
        ASSERT_NEAR(half_plane_angle(heading.x, std::max(0.0, heading.y)), angle, 2 * accuracy) << angle;
    }
}

TEST(Angle, DirectionsTurnRoundOnceAndNeverBack) {
    double sum = 0;
    glm::dvec2 before = unit_vector(0);
    constexpr int steps = 10000;
    for (int i = 1; i <= steps; ++i) {
        const glm::dvec2 here = unit_vector(2 * pi * i / steps);
        const double sine = before.x * here.y - before.y * here.x;
        ASSERT_GT(sine, 0) << i;
        sum += half_plane_angle(glm::dot(before, here), sine);
        before = here;
    }
    EXPECT_NEAR(sum, 2 * pi, steps * accuracy);
}

} // namespace
