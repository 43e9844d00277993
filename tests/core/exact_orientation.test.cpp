// Predicates that are never wrong, against rational numbers: on points at random, next to degenerate, degenerate, and as large
// and as small as the predicates allow.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <type_traits>
#include <utility>

#include <boost/multiprecision/cpp_int.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <gtest/gtest.h>

#include "geometry/exact_orientation.hpp"
#include "geometry/expansion.hpp"
#include "meshes/random.hpp"

namespace {

using namespace meshbound;
using boost::multiprecision::cpp_rational;

using InSpace = std::array<glm::dvec3, 4>;
using InPlane = std::array<glm::dvec2, 3>;

/// Powers of two that coordinates may have as factors. Nothing overflows, and no last digit of a product of three
/// coordinates (two in the plane), of 53 binary digits each, underflows.
constexpr int most_in_space = 330, least_in_space = -300, most_in_plane = 500, least_in_plane = -470;

int sign_of(const cpp_rational& number) { return number.sign(); }

cpp_rational difference_of(double a, double b) { return cpp_rational(a) - cpp_rational(b); }

int rational_orientation(const InPlane& p) {
    return sign_of(difference_of(p[1].x, p[0].x) * difference_of(p[2].y, p[0].y) -
                   difference_of(p[1].y, p[0].y) * difference_of(p[2].x, p[0].x));
}

/// The sign of (b − a) × (c − a) · (d − a).
int rational_orientation(const InSpace& p) {
    std::array<std::array<cpp_rational, 3>, 3> e;
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t axis = 0; axis < 3; ++axis)
            e[i][axis] = difference_of(p[i + 1][static_cast<int>(axis)], p[0][static_cast<int>(axis)]);
    const auto minor = [&](std::size_t x, std::size_t y) { return e[0][x] * e[1][y] - e[0][y] * e[1][x]; };
    return sign_of(minor(1, 2) * e[2][0] + minor(2, 0) * e[2][1] + minor(0, 1) * e[2][2]);
}

int predicate(const InSpace& p) { return exact_orientation(p[0], p[1], p[2], p[3]); }
int predicate(const InPlane& p) { return exact_orientation(p[0], p[1], p[2]); }

template <class Points>
void expect_right(const Points& points) {
    const int expected = rational_orientation(points);
    ASSERT_EQ(predicate(points), expected);
    for (std::size_t i = 0; i + 1 < points.size(); ++i) { // whatever the order of the points
        Points swapped = points;
        std::swap(swapped[i], swapped[i + 1]);
        ASSERT_EQ(predicate(swapped), -expected);
    }
}

constexpr int dimensions(const InSpace&) { return 3; }
constexpr int dimensions(const InPlane&) { return 2; }

template <class Points, class Coordinate>
Points points_of(Coordinate coordinate) {
    Points points;
    for (auto& point : points)
        for (int axis = 0; axis < dimensions(points); ++axis) point[axis] = coordinate();
    return points;
}

/// Moves a coordinate to one of its neighbours among the doubles, or leaves it.
void nudge(double& coordinate, meshes::Random& random) {
    const double to[] = {-HUGE_VAL, coordinate, HUGE_VAL};
    coordinate = std::nextafter(coordinate, to[random.below(3)]);
}

template <class Points>
void nudge(Points& points, meshes::Random& random) {
    for (auto& point : points)
        for (int axis = 0; axis < dimensions(points); ++axis) nudge(point[axis], random);
}

/// The last of the points put, but for rounding, into the plane (on the line) of the others.
template <class Points>
void flatten(Points& points, meshes::Random& random) {
    auto place = points[0];
    for (std::size_t i = 1; i + 1 < points.size(); ++i) place += random.uniform(-2, 2) * (points[i] - points[0]);
    points.back() = place;
}

template <class Points>
class ExactOrientation : public testing::Test {
protected:
    static constexpr bool in_space = std::is_same_v<Points, InSpace>;
    static constexpr int most = in_space ? most_in_space : most_in_plane;
    static constexpr int least = in_space ? least_in_space : least_in_plane;
};
using Dimensions = testing::Types<InSpace, InPlane>;
TYPED_TEST_SUITE(ExactOrientation, Dimensions);

TYPED_TEST(ExactOrientation, IsRightOfPointsAtRandom) {
    meshes::Random random(1);
    for (int i = 0; i < 5000; ++i) expect_right(points_of<TypeParam>([&] { return random.uniform(-1, 1); }));
}

TYPED_TEST(ExactOrientation, IsRightNextToDegenerate) {
    meshes::Random random(2);
    std::array<int, 3> seen{};
    for (int i = 0; i < 10000; ++i) {
        TypeParam points = points_of<TypeParam>([&] { return random.uniform(-1, 1); });
        flatten(points, random);
        nudge(points, random);
        expect_right(points);
        ++seen[static_cast<std::size_t>(predicate(points) + 1)];
    }
    EXPECT_GT(seen[0], 1000);
    EXPECT_GT(seen[2], 1000);
}

/// Far from the origin the points have few digits beside each other, and often none.
TYPED_TEST(ExactOrientation, IsRightFarFromTheOrigin) {
    meshes::Random random(3);
    std::array<int, 3> seen{};
    for (int i = 0; i < 10000; ++i) {
        const double spread = std::exp2(random.uniform(-52, -46));
        const TypeParam points = points_of<TypeParam>([&] { return 1 + spread * random.uniform(-1, 1); });
        expect_right(points);
        ++seen[static_cast<std::size_t>(predicate(points) + 1)];
    }
    for (const int count : seen) EXPECT_GT(count, 50);
}

TYPED_TEST(ExactOrientation, IsZeroOfWhatIsDegenerate) {
    meshes::Random random(4);
    for (int i = 0; i < 5000; ++i) {
        const double unit = std::ldexp(1.0, static_cast<int>(random.below(600)) - 300);
        TypeParam points =
            points_of<TypeParam>([&] { return unit * (static_cast<double>(random.below(200001)) - 1e5); });
        auto place = points[0];
        for (std::size_t n = 1; n + 1 < points.size(); ++n)
            place += (static_cast<double>(random.below(21)) - 10) * (points[n] - points[0]);
        points.back() = place; // without rounding: they are whole numbers
        ASSERT_EQ(predicate(points), 0);
        expect_right(points);
        double& coordinate = points.back()[static_cast<int>(random.below(2))];
        coordinate = std::nextafter(coordinate, HUGE_VAL); // and by the least step out of it
        expect_right(points);
    }
}

TYPED_TEST(ExactOrientation, IsZeroWherePointsAreOne) {
    meshes::Random random(5);
    for (int i = 0; i < 1000; ++i) {
        TypeParam points = points_of<TypeParam>([&] { return random.uniform(-1, 1); });
        const std::size_t one = random.below(points.size());
        points[one] = points[(one + 1) % points.size()];
        ASSERT_EQ(predicate(points), 0);
    }
}

/// Each with every other: most degenerate in one way or another.
TYPED_TEST(ExactOrientation, IsRightOfSmallWholeNumbers) {
    meshes::Random random(6);
    int zeros = 0;
    for (int i = 0; i < 20000; ++i) {
        const TypeParam points = points_of<TypeParam>([&] { return static_cast<double>(random.below(3)) - 1; });
        expect_right(points);
        zeros += predicate(points) == 0;
    }
    EXPECT_GT(zeros, 4000);
}

TYPED_TEST(ExactOrientation, IsRightOfNumbersAsLargeAndSmallAsMayBe) {
    meshes::Random random(7);
    for (const int exponent : {this->least, this->most}) {
        const double unit = std::ldexp(1.0, exponent);
        for (int i = 0; i < 3000; ++i) {
            TypeParam points = points_of<TypeParam>([&] { return unit * random.uniform(1, 2); });
            expect_right(points);
            flatten(points, random);
            for (int axis = 0; axis < dimensions(points); ++axis) // within the range, though not in the plane any more
                points.back()[axis] = std::clamp(points.back()[axis], unit, 2 * unit);
            nudge(points, random);
            expect_right(points);
        }
    }
}

/// In one and the same question: sums of numbers that have no digit in common.
TYPED_TEST(ExactOrientation, IsRightOfLargeAndSmallNumbersTogether) {
    meshes::Random random(8);
    const auto coordinate = [&] {
        const int exponent =
            this->least + static_cast<int>(random.below(static_cast<std::size_t>(this->most - this->least)));
        return (random.below(2) == 0 ? -1 : 1) * std::ldexp(random.uniform(1, 2), exponent);
    };
    for (int i = 0; i < 2000; ++i) {
        TypeParam points = points_of<TypeParam>(coordinate);
        expect_right(points);
        flatten(points, random);
        for (int axis = 0; axis < dimensions(points); ++axis)
            points.back()[axis] =
                std::clamp(points.back()[axis], -std::ldexp(1.0, this->most), std::ldexp(1.0, this->most));
        if (std::any_of(points.begin(), points.end(), [&](const auto& p) {
                for (int axis = 0; axis < dimensions(points); ++axis)
                    if (std::abs(p[axis]) < std::ldexp(1.0, this->least)) return true;
                return false;
            }))
            continue;
        expect_right(points);
    }
}

TEST(ExactOrientationSides, AreThoseThatTheyAreSaidToBe) {
    EXPECT_EQ(exact_orientation({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}), 1);
    EXPECT_EQ(exact_orientation({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {5, 5, -1}), -1);
    EXPECT_EQ(exact_orientation({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {7, -3, 0}), 0);
    EXPECT_EQ(exact_orientation({0, 0}, {1, 0}, {0, 1}), 1);
    EXPECT_EQ(exact_orientation({0, 0}, {0, 1}, {1, 0}), -1);
    EXPECT_EQ(exact_orientation({0, 0}, {1, 1}, {3, 3}), 0);
}

template <std::size_t N>
cpp_rational value(const Expansion<N>& e) {
    cpp_rational sum = 0;
    for (std::size_t i = 0; i < e.count; ++i) sum += cpp_rational(e.parts[i]);
    return sum;
}

/// The smallest first, none zero, and each beyond the last digit of the one before, so that the last has the sum's sign.
template <std::size_t N>
void expect_expansion(const Expansion<N>& e, const cpp_rational& expected) {
    ASSERT_EQ(value(e), expected);
    ASSERT_EQ(e.sign(), expected.sign());
    for (std::size_t i = 0; i < e.count; ++i) ASSERT_NE(e.parts[i], 0);
    cpp_rational below = 0;
    for (std::size_t i = 0; i < e.count; ++i) {
        ASSERT_LT(abs(below), abs(cpp_rational(e.parts[i])));
        below += cpp_rational(e.parts[i]);
    }
}

TEST(Expansion, HoldsSumsAndProductsExactly) {
    meshes::Random random(9);
    const auto number = [&] {
        if (random.below(8) == 0) return 0.0;
        return random.uniform(-1, 1) * std::ldexp(1.0, static_cast<int>(random.below(120)) - 60);
    };
    for (int i = 0; i < 5000; ++i) {
        const double a = number(), b = random.below(8) == 0 ? a : number(), c = number(), d = number(), f = number();
        const auto ab = difference(a, b), cd = difference(c, d);
        expect_expansion(ab, cpp_rational(a) - cpp_rational(b));
        expect_expansion(sum(ab, cd), value(ab) + value(cd));
        expect_expansion(sum(ab, negated(ab)), 0);
        expect_expansion(product(ab, f), value(ab) * cpp_rational(f));
        expect_expansion(product(ab, cd), value(ab) * value(cd));
        expect_expansion(product(product(ab, cd), difference(f, a)),
                         value(ab) * value(cd) * (cpp_rational(f) - cpp_rational(a)));
    }
}

TEST(Expansion, LosesNothingOfOneOperation) {
    meshes::Random random(10);
    for (int i = 0; i < 20000; ++i) {
        const double a = random.uniform(-1, 1) * std::exp2(random.uniform(-200, 200));
        const double b = random.uniform(-1, 1) * std::exp2(random.uniform(-200, 200));
        const Rounded sum = exact_sum(a, b), product = exact_product(a, b), halves = split(a);
        ASSERT_EQ(sum.value, a + b);
        ASSERT_EQ(cpp_rational(sum.value) + cpp_rational(sum.rest), cpp_rational(a) + cpp_rational(b));
        ASSERT_EQ(product.value, a * b);
        ASSERT_EQ(cpp_rational(product.value) + cpp_rational(product.rest), cpp_rational(a) * cpp_rational(b));
        ASSERT_EQ(halves.value + halves.rest, a);
    }
}

} // namespace
