// The place where the largest ratio is least, against a fine grid of places.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include <glm/vec2.hpp>
#include <gtest/gtest.h>

#include "errors/tracked/joint_space.hpp"
#include "meshbound/bounds.hpp"
#include "meshes/random.hpp"
#include "meshes/shapes.hpp"
#include "metric/bounded_rows.hpp"
#include "metric/minimax.hpp"
#include "metric/rows.hpp"

namespace {

using namespace meshbound;

/// Cells along each side of the grid.
constexpr int fineness = 120;

/// Rows of four vertices at random: position and some scalars and a vector, each with a bound of 1.
class FourRows {
public:
    /// `mixed`: what the last row has, of the other three's components; at random where there is none.
    FourRows(meshes::Random& random, int scalars, bool vector,
             const std::function<double(double, double, double)>& mixed = {}) {
        Mesh mesh = meshes::from_points(std::vector<glm::dvec3>(4), {{0, 1, 2}, {1, 3, 2}});
        const auto fill = [&](int components, Values& filled) {
            std::vector<double> values(4 * static_cast<std::size_t>(components));
            for (double& value : values) value = random.uniform(-1, 1);
            const std::size_t n = values.size() / 4;
            for (std::size_t i = 0; mixed && i < n; ++i)
                values[3 * n + i] = mixed(values[i], values[n + i], values[2 * n + i]);
            filled = values;
        };
        fill(3, mesh.position.values);
        for (int i = 0; i < scalars; ++i) mesh.variables.push_back({"scalar " + std::to_string(i), 1, {}});
        if (vector) mesh.variables.push_back({"vector", 3, {}});
        for (Variable& variable : mesh.variables) fill(variable.components, variable.values);
        std::vector<ResolvedBound> resolved;
        EXPECT_TRUE(resolve_bounds(mesh, {{"*", absolute(1)}}, resolved).ok());
        rows_ = Rows(mesh, resolved);
    }
    const Rows& rows() const { return rows_; }

private:
    Rows rows_;
};

/// The places w − x u − y v of a triangle or a pair of segments.
class Question {
public:
    virtual ~Question() = default;
    virtual double ratio(const glm::dvec2& place) const = 0; ///< the largest, squared, by the measured rows themselves
    virtual glm::dvec2 place(double s, double t) const = 0;  ///< the allowed ones, of s and t from 0 to 1
    virtual bool allows(const glm::dvec2& place) const = 0;
    virtual void improve(Minimax::Solution& best) const = 0;
};

class TriangleQuestion : public Question {
public:
    explicit TriangleQuestion(const Rows& rows) : measured_(rows) {}
    double ratio(const glm::dvec2& p) const override {
        return measured_.squared_ratio(measured_[3], measured_[0], measured_[1], measured_[2], 1 - p.x - p.y, p.x, p.y);
    }
    glm::dvec2 place(double s, double t) const override { return {s * (1 - t), t}; }
    bool allows(const glm::dvec2& p) const override { return p.x >= 0 && p.y >= 0 && p.x + p.y <= 1 + 1e-15; }
    void improve(Minimax::Solution& best) const override {
        Minimax minimax(measured_);
        minimax.enter(within({measured_[0], measured_[1], measured_[2]}, measured_[3]));
        minimax.improve(best, [](const PlaneProducts& products) { return nearest_in_triangle(products); });
    }

private:
    BoundedRows measured_;
};

class SegmentsQuestion : public Question {
public:
    SegmentsQuestion(const Rows& rows, double low, double high) : measured_(rows), low_(low), high_(high) {}
    double ratio(const glm::dvec2& p) const override {
        return measured_.squared_ratio(
            BoundedRows::segment_difference(measured_[0], measured_[1], p.x, measured_[2], measured_[3], p.y));
    }
    glm::dvec2 place(double s, double t) const override { return {low_ + s * (high_ - low_), t}; }
    bool allows(const glm::dvec2& p) const override { return p.x >= low_ && p.x <= high_ && p.y >= 0 && p.y <= 1; }
    void improve(Minimax::Solution& best) const override {
        Minimax minimax(measured_);
        minimax.enter(between({measured_[0], measured_[1]}, {measured_[2], measured_[3]}));
        minimax.improve(best, [this](const PlaneProducts& p) { return nearest_parameters(p, low_, high_); });
    }

private:
    BoundedRows measured_;
    double low_, high_;
};

/// The largest ratio where the algorithm led, over that of the grid's best place; below 1 where it lies between the grid's.
/// It must never be worse than at the start, and be what it is said to be.
double against_grid(const Question& question, const glm::dvec2& start) {
    Minimax::Solution best{start, question.ratio(start)};
    const double at_start = best.squared_ratio;
    question.improve(best);
    EXPECT_TRUE(question.allows(best.parameters)) << best.parameters.x << ' ' << best.parameters.y;
    EXPECT_LE(best.squared_ratio, at_start);
    EXPECT_NEAR(best.squared_ratio, question.ratio(best.parameters), 1e-12);
    double least = at_start;
    for (int i = 0; i <= fineness; ++i)
        for (int j = 0; j <= fineness; ++j)
            least = std::min(least, question.ratio(question.place(double(i) / fineness, double(j) / fineness)));
    return std::sqrt(best.squared_ratio / least);
}

/// What eight rounds come to: half of the places are within 1 % of the grid's best ratio, 95 % within 2.5 %, all within 5 %.
void expect_near_the_best(std::vector<double> ratios) {
    std::sort(ratios.begin(), ratios.end());
    EXPECT_LT(ratios[ratios.size() / 2], 1.01);
    EXPECT_LT(ratios[ratios.size() * 95 / 100], 1.025);
    EXPECT_LT(ratios.back(), 1.05);
}

/// Position alone, with scalars, with another vector, and with all of them.
struct Variables {
    int scalars;
    bool vector;
};
class MinimaxTest : public testing::TestWithParam<Variables> {};
INSTANTIATE_TEST_SUITE_P(Variables, MinimaxTest,
                         testing::Values(Variables{0, false}, Variables{0, true}, Variables{1, false},
                                         Variables{3, false}, Variables{3, true}, Variables{6, true}),
                         [](const auto& variables) {
                             return std::to_string(variables.param.scalars) + "Scalars" +
                                    (variables.param.vector ? "AndAVector" : "");
                         });

constexpr int questions = 300;

TEST_P(MinimaxTest, InATriangleComesNearTheBestOfAGrid) {
    meshes::Random random(1);
    std::vector<double> ratios;
    for (int n = 0; n < questions; ++n) {
        const FourRows four(random, GetParam().scalars, GetParam().vector);
        const TriangleQuestion question(four.rows());
        ratios.push_back(against_grid(question, question.place(random.uniform(0, 1), random.uniform(0, 1))));
    }
    expect_near_the_best(ratios);
}

TEST_P(MinimaxTest, OfTwoSegmentsComesNearTheBestOfAGrid) {
    meshes::Random random(2);
    std::vector<double> ratios;
    for (int n = 0; n < questions; ++n) {
        const FourRows four(random, GetParam().scalars, GetParam().vector);
        const double low = random.uniform(0, 0.5), high = random.uniform(0.5, 1);
        const SegmentsQuestion question(four.rows(), low, high);
        ratios.push_back(against_grid(question, question.place(random.uniform(0, 1), random.uniform(0, 1))));
    }
    expect_near_the_best(ratios);
}

/// As where a vertex goes to the closing edge: one end of one segment only.
TEST_P(MinimaxTest, OfAPointAndASegmentComesNearTheBestOfAGrid) {
    meshes::Random random(3);
    std::vector<double> ratios;
    for (int n = 0; n < questions; ++n) {
        const FourRows four(random, GetParam().scalars, GetParam().vector);
        const SegmentsQuestion question(four.rows(), 0, 0);
        ratios.push_back(against_grid(question, question.place(0, random.uniform(0, 1))));
    }
    expect_near_the_best(ratios);
}

/// The place of least squares, from which the reduction starts, is made better by it more often than not.
TEST_P(MinimaxTest, IsBetterThanLeastSquaresWhereThereAreSeveralVariables) {
    meshes::Random random(4);
    int better = 0;
    for (int n = 0; n < questions; ++n) {
        const FourRows four(random, GetParam().scalars, GetParam().vector);
        const BoundedRows rows(four.rows());
        const SegmentsQuestion question(four.rows(), 0, 1);
        const glm::dvec2 nearest = nearest_parameters(products_of(rows, {rows[0], rows[1]}, {rows[2], rows[3]}), 0, 1);
        Minimax::Solution best{nearest, question.ratio(nearest)};
        const double before = best.squared_ratio;
        question.improve(best);
        better += best.squared_ratio < 0.999 * before;
    }
    const bool several = GetParam().scalars > 0 || GetParam().vector;
    EXPECT_EQ(better > questions / 4, several) << better;
}

TEST_P(MinimaxTest, LeavesAPlaceThatIsBetterThanAllItFinds) {
    meshes::Random random(5);
    for (int n = 0; n < questions; ++n) {
        const FourRows four(random, GetParam().scalars, GetParam().vector);
        const TriangleQuestion question(four.rows());
        Minimax::Solution best{{0.25, 0.5}, 1e-9};
        question.improve(best);
        ASSERT_EQ(best.parameters, glm::dvec2(0.25, 0.5));
        ASSERT_EQ(best.squared_ratio, 1e-9);
    }
}

/// Where there is a place without any error it is found, and nothing is divided by the nothing that is left.
TEST_P(MinimaxTest, FindsThePlaceWithoutError) {
    meshes::Random random(6);
    for (int n = 0; n < questions; ++n) {
        const double x = random.uniform(0, 0.5), y = random.uniform(0, 0.5);
        const FourRows four(random, GetParam().scalars, GetParam().vector,
                            [&](double a, double b, double c) { return (1 - x - y) * a + x * b + y * c; });
        const TriangleQuestion question(four.rows());
        Minimax::Solution best{{0, 0}, question.ratio({0, 0})};
        question.improve(best);
        ASSERT_LT(best.squared_ratio, 1e-12);
        ASSERT_NEAR(best.parameters.x, x, 1e-4);
        ASSERT_NEAR(best.parameters.y, y, 1e-4);
    }
}

/// Any place of a triangle that is but a point is as good as another.
TEST_P(MinimaxTest, HoldsForATriangleThatIsAPoint) {
    meshes::Random random(7);
    for (int n = 0; n < 20; ++n) {
        const FourRows four(random, GetParam().scalars, GetParam().vector);
        const BoundedRows rows(four.rows());
        Minimax minimax(rows);
        minimax.enter(within({rows[0], rows[0], rows[0]}, rows[3]));
        const double ratio = rows.squared_ratio(rows[3], rows[0], rows[0], rows[0], 1, 0, 0);
        Minimax::Solution best{{0, 0}, 2 * ratio};
        minimax.improve(best, [](const PlaneProducts& products) { return nearest_in_triangle(products); });
        ASSERT_NEAR(best.squared_ratio, ratio, 1e-12);
    }
}

} // namespace
