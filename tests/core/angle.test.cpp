// Angles without libm, against libm.

#include "angle.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "meshes/random.hpp"

namespace {

using namespace meshbound;

/// What angle.hpp states.
constexpr double accuracy = 1e-13;

TEST(Angle, OfAVectorInTheUpperHalfPlane) {
    meshes::Random random(1);
    for (int i = 0; i < 20'000; ++i) {
        const double scale = std::pow(10.0, random.uniform(-150, 150));
        const double x = scale * random.uniform(-1, 1), y = scale * random.uniform(0, 1);
        EXPECT_NEAR(half_plane_angle(x, y), std::atan2(y, x), accuracy) << x << ", " << y;
    }
    for (const auto& [x, y] : {std::pair{1.0, 0.0},
                               {-1.0, 0.0},
                               {0.0, 1.0},
                               {1.0, 1.0},
                               {-1.0, 1.0},
                               {1e-300, 1e300},
                               {1e300, 1e-300},
                               {-1e300, 1e-300},
                               {1.0, 1e-17}})
        EXPECT_NEAR(half_plane_angle(x, y), std::atan2(y, x), accuracy) << x << ", " << y;
    EXPECT_EQ(half_plane_angle(0, 0), 0);
}

TEST(Angle, DoesNotDependOnTheLength) {
    meshes::Random random(2);
    for (int i = 0; i < 2'000; ++i) {
        const double x = random.uniform(-1, 1), y = random.uniform(0, 1);
        EXPECT_EQ(half_plane_angle(x, y), half_plane_angle(1024 * x, 1024 * y));
    }
}

TEST(Angle, RisesAllTheWayRound) {
    constexpr int steps = 100'000;
    double before = -1;
    for (int i = 0; i <= steps; ++i) {
        const double turned = pi * i / steps;
        const double angle = half_plane_angle(std::cos(turned), std::sin(turned));
        EXPECT_GT(angle, before) << i;
        before = angle;
    }
}

TEST(Angle, ItsDirectionIsThatOfTheUnitCircle) {
    for (int i = 0; i <= 4'000; ++i) {
        const double angle = 2 * pi * i / 4'000;
        const glm::dvec2 here = direction(angle);
        EXPECT_NEAR(here.x, std::cos(angle), accuracy) << angle;
        EXPECT_NEAR(here.y, std::sin(angle), accuracy) << angle;
        if (angle < pi) {
            EXPECT_NEAR(half_plane_angle(here.x, here.y), angle, 2 * accuracy);
        }
    }
}

} // namespace
