// The judge's nearest point of a triangle in the norm max(|Δx| / bound, |Δf| / bound, ...), against nested search.

#include "verify/joint_distance.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include <gtest/gtest.h>

#include "meshes/random.hpp"

namespace {

namespace verification = meshbound::verification;

using verification::JointDistance;
using verification::Nearest;
using Row = std::vector<double>;

struct Case {
    std::vector<int> components;
    Row q, a, b, c;
};

Row random_row(meshes::Random& random, std::size_t dimensions, double size) {
    Row row(dimensions);
    for (double& x : row) x = size * random.uniform(-1, 1);
    return row;
}

/// Random variables, a random triangle, and a point near or far from it.
Case random_case(std::uint64_t seed) {
    meshes::Random random(seed);
    Case one;
    std::size_t dimensions = 3;
    one.components = {3};
    for (std::size_t more = random.below(8); more > 0; --more) {
        one.components.push_back(random.below(3) == 0 ? 3 : 1);
        dimensions += static_cast<std::size_t>(one.components.back());
    }
    const double size = std::pow(10.0, random.uniform(-1, 5));
    one.a = random_row(random, dimensions, size);
    one.b = random_row(random, dimensions, size);
    one.c = random_row(random, dimensions, size);
    const double u = random.uniform(-0.2, 0.6), v = random.uniform(-0.2, 0.6);
    one.q = random_row(random, dimensions, 2);
    for (std::size_t i = 0; i < dimensions; ++i)
        one.q[i] += one.a[i] + u * (one.b[i] - one.a[i]) + v * (one.c[i] - one.a[i]);
    if (random.below(5) == 0) one.c = one.b;         // a segment
    if (random.below(9) == 0) one.b = one.c = one.a; // a point
    if (random.below(9) == 0)                        // a needle
        for (std::size_t i = 0; i < dimensions; ++i) one.c[i] = one.b[i] + 1e-9 * one.c[i];
    if (random.below(4) == 0) // variables that do not change along u
        for (std::size_t i = 3; i < dimensions; ++i) one.b[i] = one.a[i];
    return one;
}

double at(const Case& one, const JointDistance& metric, double u, double v) {
    Row p(one.q.size());
    for (std::size_t i = 0; i < p.size(); ++i) p[i] = one.a[i] + u * (one.b[i] - one.a[i]) + v * (one.c[i] - one.a[i]);
    return metric.between(one.q.data(), p.data());
}

/// The least value of a convex function between two ends.
double search(double low, double high, const std::function<double(double)>& f) {
    const double golden = (std::sqrt(5.0) - 1) / 2;
    double x = high - golden * (high - low), y = low + golden * (high - low);
    double at_x = f(x), at_y = f(y);
    for (int i = 0; i < 60; ++i) {
        if (at_x < at_y) {
            high = y;
            y = x;
            at_y = at_x;
            x = high - golden * (high - low);
            at_x = f(x);
        } else {
            low = x;
            x = y;
            at_x = at_y;
            y = low + golden * (high - low);
            at_y = f(y);
        }
    }
    return std::min(at_x, at_y);
}

double brute_force(const Case& one, const JointDistance& metric) {
    return search(0, 1, [&](double u) { return search(0, 1 - u, [&](double v) { return at(one, metric, u, v); }); });
}

Nearest solve(const Case& one, const JointDistance& metric, double enough = 0,
              double cutoff = JointDistance::infinite) {
    return metric.to_triangle(one.q.data(), one.a.data(), one.b.data(), one.c.data(), enough, cutoff);
}

TEST(JointDistance, IsTheMinimumOverTheTriangle) {
    for (std::uint64_t seed = 0; seed < 600; ++seed) {
        const Case one = random_case(seed);
        const JointDistance metric(one.components);
        const Nearest found = solve(one, metric);
        const double least = brute_force(one, metric);
        EXPECT_NEAR(found.distance, least, 1e-6 * std::max(1.0, least)) << "seed " << seed;
    }
}

TEST(JointDistance, IsAttainedAtTheReturnedPlaceInsideTheTriangle) {
    for (std::uint64_t seed = 0; seed < 2000; ++seed) {
        const Case one = random_case(seed);
        const JointDistance metric(one.components);
        const Nearest found = solve(one, metric);
        EXPECT_GE(found.u, 0) << "seed " << seed;
        EXPECT_GE(found.v, 0) << "seed " << seed;
        EXPECT_LE(found.u + found.v, 1 + 1e-15) << "seed " << seed;
        EXPECT_DOUBLE_EQ(at(one, metric, found.u, found.v), found.distance) << "seed " << seed;
    }
}

TEST(JointDistance, StopsEarlyOnlyWhereThatIsTrue) {
    for (std::uint64_t seed = 0; seed < 2000; ++seed) {
        const Case one = random_case(seed);
        const JointDistance metric(one.components);
        const double exact = solve(one, metric).distance;
        const double slack = 2 * JointDistance::accuracy * std::max(1.0, exact);
        EXPECT_LE(solve(one, metric, 1.1 * exact).distance, 1.1 * exact + slack) << "seed " << seed;
        EXPECT_NEAR(solve(one, metric, 0.9 * exact).distance, exact, slack) << "seed " << seed;
        EXPECT_NEAR(solve(one, metric, 0, 1.1 * exact + slack).distance, exact, slack) << "seed " << seed;
        EXPECT_GE(solve(one, metric, 0, 0.9 * exact).distance, exact - slack) << "seed " << seed;
    }
}

TEST(JointDistance, FindsAPointOfAHugeTriangleOrSegment) {
    for (std::uint64_t seed = 0; seed < 1000; ++seed) {
        meshes::Random random(seed);
        const double size = seed % 2 == 0 ? 1e9 : 1e6;
        Case one{{3, 1, 3}, {}, random_row(random, 7, size), random_row(random, 7, size), random_row(random, 7, size)};
        if (seed % 4 < 2) one.c = one.b;
        const double u = random.uniform(0, 0.5), v = random.uniform(0, 0.5);
        for (std::size_t i = 0; i < 7; ++i)
            one.q.push_back(one.a[i] + u * (one.b[i] - one.a[i]) + v * (one.c[i] - one.a[i]));
        // The places themselves are rounded to a few units in the last place.
        EXPECT_LT(solve(one, JointDistance(one.components)).distance, 2e-15 * size) << "seed " << seed;
    }
}

TEST(JointDistance, IsTheMinimumOverASegmentThatIsHugeBesideTheBounds) {
    for (std::uint64_t seed = 0; seed < 1000; ++seed) {
        meshes::Random random(seed);
        const double size = std::pow(10.0, random.uniform(2, 6));
        Case one{{3, 1, 1, 1}, random_row(random, 6, 1), random_row(random, 6, size), random_row(random, 6, size), {}};
        one.c = one.b;
        const double u = random.uniform(0, 1);
        for (std::size_t i = 0; i < 6; ++i) one.q[i] += one.a[i] + u * (one.b[i] - one.a[i]);
        const JointDistance metric(one.components);
        const double least = search(0, 1, [&](double along) { return at(one, metric, along, 0); });
        EXPECT_NEAR(solve(one, metric).distance, least, 1e-6 * std::max(1.0, least)) << "seed " << seed;
    }
}

TEST(JointDistance, OfOneVariableIsTheEuclideanOne) {
    const JointDistance metric({3});
    const Case one{{3}, {1, 1, 5}, {0, 0, 0}, {4, 0, 0}, {0, 4, 0}};
    EXPECT_NEAR(solve(one, metric).distance, 5, 1e-12);
    const Case beyond{{3}, {7, 0, 4}, {0, 0, 0}, {4, 0, 0}, {0, 4, 0}};
    EXPECT_NEAR(solve(beyond, metric).distance, 5, 1e-12);
}

TEST(JointDistance, BalancesTwoVariables) {
    // Position wants u = 0.5, the value wants u = 1; both grow by one a unit of u, so that they meet half-way.
    const JointDistance metric({3, 1});
    const Case one{{3, 1}, {0.5, 0, 0, 1}, {0, 0, 0, 0}, {1, 0, 0, 1}, {0, 1, 0, 0}};
    const Nearest found = solve(one, metric);
    EXPECT_NEAR(found.distance, 0.25, 1e-7);
    EXPECT_NEAR(found.u, 0.75, 1e-6);
}

} // namespace
