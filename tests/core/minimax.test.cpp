// Lawson's algorithm finds places whose largest ratio is close to the least, against a fine grid.

#include "metric/minimax.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "errors/tracked/joint_space.hpp"
#include "meshbound/bounds.hpp"
#include "meshes/random.hpp"

namespace {

using namespace meshbound;

/// Points with a position, a vector and some scalars; the first three are a triangle.
class Points {
public:
    Points(meshes::Random& random, std::size_t count) {
        const auto numbers = [&](std::size_t components) {
            std::vector<double> values(count * components);
            for (double& value : values) value = random.uniform(-1, 1);
            return values;
        };
        mesh_.position.values = numbers(3);
        for (std::uint32_t v = 0; v + 2 < count; ++v) mesh_.triangles.push_back({v, v + 1, v + 2});
        mesh_.variables.push_back({"vector", 3, numbers(3)});
        for (std::size_t i = random.below(4); i > 0; --i)
            mesh_.variables.push_back({"s" + std::to_string(i), 1, numbers(1)});
        std::vector<ResolvedBound> bounds;
        EXPECT_TRUE(resolve_bounds(mesh_, {{"*", relative(0.2)}}, bounds).ok());
        rows_ = Rows(mesh_, bounds);
    }
    const Rows& rows() const { return rows_; }

private:
    Mesh mesh_;
    Rows rows_;
};

struct Found {
    double least_squares, chosen, grid;
};

/// Where fine steps over the triangle come lowest.
Found in_triangle(const BoundedRows& rows) {
    const double *a = rows[0], *b = rows[1], *c = rows[2], *row = rows[3];
    const auto ratio_at = [&](double x, double y) { return rows.squared_ratio(row, a, b, c, 1 - x - y, x, y); };
    Minimax minimax(rows);
    minimax.enter(within({a, b, c}, row));
    PlaneProducts sum;
    rows.sum_by_variable<LaneProducts>(within({a, b, c}, row), [&](const PlaneProducts& one) { sum.add(one, 1); });
    const glm::dvec2 first = nearest_in_triangle(sum);
    Minimax::Solution best{first, ratio_at(first.x, first.y)};
    const double before = best.squared_ratio;
    minimax.improve(best, [](const PlaneProducts& products) { return nearest_in_triangle(products); });
    EXPECT_NEAR(best.squared_ratio, ratio_at(best.parameters.x, best.parameters.y), 1e-9 * (1 + best.squared_ratio));
    EXPECT_GE(std::min({best.parameters.x, best.parameters.y, 1 - best.parameters.x - best.parameters.y}), -1e-12);
    double least = before;
    constexpr int steps = 120;
    for (int i = 0; i <= steps; ++i)
        for (int k = 0; i + k <= steps; ++k) least = std::min(least, ratio_at(double(i) / steps, double(k) / steps));
    return {before, best.squared_ratio, least};
}

Found between_segments(const BoundedRows& rows) {
    const JointSegment one{rows[0], rows[1]}, other{rows[2], rows[3]};
    const auto ratio_at = [&](double s, double t) {
        return rows.squared_ratio(BoundedRows::segment_difference(one.start, one.end, s, other.start, other.end, t));
    };
    Minimax minimax(rows);
    minimax.enter(between(one, other));
    const auto nearest = [](const PlaneProducts& products) { return nearest_parameters(products, 0.1, 0.9); };
    const glm::dvec2 first = nearest(products_of(rows, one, other));
    Minimax::Solution best{first, ratio_at(first.x, first.y)};
    const double before = best.squared_ratio;
    minimax.improve(best, nearest);
    EXPECT_NEAR(best.squared_ratio, ratio_at(best.parameters.x, best.parameters.y), 1e-9 * (1 + best.squared_ratio));
    EXPECT_TRUE(best.parameters.x >= 0.1 && best.parameters.x <= 0.9 && best.parameters.y >= 0 &&
                best.parameters.y <= 1);
    double least = before;
    constexpr int steps = 100;
    for (int i = 0; i <= steps; ++i)
        for (int k = 0; k <= steps; ++k) least = std::min(least, ratio_at(0.1 + 0.8 * i / steps, double(k) / steps));
    return {before, best.squared_ratio, least};
}

/// It stops after some rounds, so that it comes close and seldom all the way: how much of what least squares leave above the
/// least does it take away?
template <class Find>
void expect_close(const Find& find) {
    double left = 0, over = 0;
    for (std::uint64_t seed = 1; seed <= 300; ++seed) {
        SCOPED_TRACE(seed);
        meshes::Random random(seed);
        const Points points(random, 4);
        const Found found = find(BoundedRows(points.rows()));
        EXPECT_LE(found.chosen, found.least_squares); // never worse than where it began
        over += std::sqrt(found.least_squares) - std::sqrt(found.grid);
        left += std::max(0.0, std::sqrt(found.chosen) - std::sqrt(found.grid));
    }
    EXPECT_GT(over, 1);
    EXPECT_LT(left, 0.15 * over);
}

TEST(Minimax, ComesCloseToTheLeastLargestRatioOnATriangle) { expect_close(in_triangle); }

TEST(Minimax, ComesCloseToTheLeastLargestRatioBetweenSegments) { expect_close(between_segments); }

} // namespace
