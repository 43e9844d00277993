// The exact predicates against arithmetic with rational numbers of any size.

#include "exact_orientation.hpp"

#include <cmath>

#include <CGAL/Exact_rational.h>
#include <gtest/gtest.h>

#include "meshes/random.hpp"

namespace {

using namespace meshbound;
using Rational = CGAL::Exact_rational;

int sign_of(const Rational& number) { return number > 0 ? 1 : number < 0 ? -1 : 0; }

int rational_orientation(const glm::dvec2& p, const glm::dvec2& q, const glm::dvec2& r) {
    const Rational ux = Rational(q.x) - Rational(p.x), uy = Rational(q.y) - Rational(p.y);
    const Rational vx = Rational(r.x) - Rational(p.x), vy = Rational(r.y) - Rational(p.y);
    return sign_of(ux * vy - uy * vx);
}

/// The determinant of a - d, b - d, c - d.
int rational_orientation(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, const glm::dvec3& d) {
    Rational m[3][3];
    const glm::dvec3* rows[3] = {&a, &b, &c};
    for (int i = 0; i < 3; ++i)
        for (int k = 0; k < 3; ++k) m[i][k] = Rational((*rows[i])[k]) - Rational(d[k]);
    return sign_of(m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
                   m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
                   m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]));
}

double some_number(meshes::Random& random) {
    switch (random.below(5)) {
    case 0: return 0;
    case 1: return static_cast<double>(random.below(5)) - 2;
    case 2: return std::ldexp(random.uniform(-1, 1), static_cast<int>(random.below(60)) - 30);
    default: return random.uniform(-1, 1);
    }
}

template <class Point>
Point some_point(meshes::Random& random) {
    Point p;
    for (int k = 0; k < Point::length(); ++k) p[k] = some_number(random);
    return p;
}

/// One unit in the last place up or down, or not at all, in each coordinate. Zero has no such unit within the documented sizes.
template <class Point>
Point nudged(meshes::Random& random, Point p) {
    constexpr double beside_zero = 1e-100;
    for (int k = 0; k < Point::length(); ++k) {
        if (random.below(2) == 0) continue;
        const double way = random.below(2) == 0 ? -1 : 1;
        p[k] = p[k] == 0 ? way * beside_zero : std::nextafter(p[k], way * 10);
    }
    return p;
}

TEST(ExactOrientation, OfAnyThreePointsInThePlane) {
    meshes::Random random(1);
    for (int i = 0; i < 20'000; ++i) {
        const auto p = some_point<glm::dvec2>(random), q = some_point<glm::dvec2>(random),
                   r = some_point<glm::dvec2>(random);
        EXPECT_EQ(exact_orientation(p, q, r), rational_orientation(p, q, r)) << i;
    }
}

TEST(ExactOrientation, OfThreePointsNearlyOnALine) {
    meshes::Random random(2);
    int on_the_line = 0;
    for (int i = 0; i < 20'000; ++i) {
        const auto p = some_point<glm::dvec2>(random), q = some_point<glm::dvec2>(random);
        const glm::dvec2 r = nudged(random, p + static_cast<double>(random.below(4)) * 0.5 * (q - p));
        const int expected = rational_orientation(p, q, r);
        on_the_line += expected == 0;
        EXPECT_EQ(exact_orientation(p, q, r), expected) << i;
    }
    EXPECT_GT(on_the_line, 100);
}

TEST(ExactOrientation, OfAnyFourPointsInSpace) {
    meshes::Random random(3);
    for (int i = 0; i < 20'000; ++i) {
        const auto a = some_point<glm::dvec3>(random), b = some_point<glm::dvec3>(random),
                   c = some_point<glm::dvec3>(random), d = some_point<glm::dvec3>(random);
        // One, where a, b, c run counter-clockwise seen from d: then a - d, b - d, c - d is no right-handed system.
        const int expected = -rational_orientation(a, b, c, d);
        EXPECT_EQ(exact_orientation(a, b, c, d), expected) << i;
    }
}

TEST(ExactOrientation, OfFourPointsNearlyInAPlane) {
    meshes::Random random(4);
    int in_the_plane = 0;
    for (int i = 0; i < 20'000; ++i) {
        const auto a = some_point<glm::dvec3>(random), b = some_point<glm::dvec3>(random),
                   c = some_point<glm::dvec3>(random);
        const double u = static_cast<double>(random.below(4)) * 0.5, v = static_cast<double>(random.below(4)) * 0.25;
        const glm::dvec3 d = nudged(random, a + u * (b - a) + v * (c - a));
        const int expected = -rational_orientation(a, b, c, d);
        in_the_plane += expected == 0;
        EXPECT_EQ(exact_orientation(a, b, c, d), expected) << i;
    }
    EXPECT_GT(in_the_plane, 100);
}

TEST(ExactOrientation, WithinTheSizesThatAreDocumented) {
    meshes::Random random(5);
    for (int i = 0; i < 5'000; ++i) {
        glm::dvec3 p[4];
        for (glm::dvec3& point : p)
            for (int k = 0; k < 3; ++k)
                point[k] =
                    random.below(3) == 0 ? 0 : std::ldexp(random.uniform(-1, 1), -static_cast<int>(random.below(140)));
        EXPECT_EQ(exact_orientation(p[0], p[1], p[2], p[3]), -rational_orientation(p[0], p[1], p[2], p[3])) << i;
    }
}

} // namespace
