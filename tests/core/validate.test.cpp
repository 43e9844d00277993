// Every fault of the input is found, named, and leaves the reduction untouched.

#include <cmath>
#include <functional>
#include <limits>
#include <set>
#include <string>
#include <variant>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "guarantee.hpp"
#include "meshbound/meshbound.hpp"
#include "meshes/defects.hpp"
#include "meshes/fields.hpp"
#include "meshes/shapes.hpp"

namespace {

using namespace meshbound;
using testing::HasSubstr;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

std::vector<double>& doubles(auto& variable) { return std::get<std::vector<double>>(variable.values); }

/// A sound call, to be broken in one place by each test.
struct Input {
    Mesh mesh = meshes::plane(3, 3);
    Bounds bounds = {{"*", relative(0.01)}};
    Options options;
    Input() {
        meshes::add_scalar(mesh, "heat", meshes::wave_field);
        meshes::add_vector(mesh, "wind", meshes::whirl_field);
    }
};

/// Reduces a broken input: it must fail with this fault and touch nothing.
Status fault_of(const std::function<void(Input&)>& break_it) {
    Input input;
    break_it(input);
    Reduction reduction;
    reduction.vertices = {1, 2, 3};
    reduction.mesh.triangles = {{7, 8, 9}};
    reduction.report.triangles_before = 42;
    int calls = 0;
    Status status = reduce(input.mesh, input.bounds, input.options, reduction, [&calls](double) {
        ++calls;
        return true;
    });
    EXPECT_EQ(reduction.vertices, (std::vector<std::uint32_t>{1, 2, 3}));
    EXPECT_EQ(reduction.mesh.triangles, (std::vector<glm::uvec3>{{7, 8, 9}}));
    EXPECT_EQ(reduction.report.triangles_before, 42U);
    EXPECT_EQ(calls, 0) << "progress of a call that never began";
    EXPECT_FALSE(status.ok());
    EXPECT_FALSE(status.message.empty());
    EXPECT_TRUE(status.message.ends_with('.')) << status.message;
    return status;
}

TEST(Validate, ASoundInputIsFine) {
    const Input input;
    Reduction reduction;
    EXPECT_TRUE(reduce(input.mesh, input.bounds, input.options, reduction).ok());
    EXPECT_TRUE(validate(input.mesh).ok());
    EXPECT_EQ(validate(input.mesh).fault, Fault::none);
}

TEST(Validate, NoTriangles) {
    EXPECT_EQ(fault_of([](Input& input) { input.mesh.triangles.clear(); }).fault, Fault::no_triangles);
    EXPECT_EQ(fault_of([](Input& input) { input.mesh = Mesh{}; }).fault, Fault::no_triangles);
    EXPECT_EQ(fault_of([](Input& input) { input.mesh.triangles = {{1, 1, 2}, {3, 3, 3}}; }).fault, Fault::no_triangles);
}

TEST(Validate, BadCoordinates) {
    const Status status = fault_of([](Input& input) { doubles(input.mesh.position).pop_back(); });
    EXPECT_EQ(status.fault, Fault::bad_coordinates);
    EXPECT_EQ(status.variable, "position");
    EXPECT_THAT(status.message, HasSubstr("47"));
}

TEST(Validate, BadIndex) {
    const Status status = fault_of([](Input& input) { input.mesh.triangles[7].y = 16; });
    EXPECT_EQ(status.fault, Fault::bad_index);
    EXPECT_EQ(status.index, 7U);
    EXPECT_THAT(status.message, HasSubstr("7"));
    EXPECT_THAT(status.message, HasSubstr("vertex 16"));
    EXPECT_THAT(status.message, HasSubstr("16 vertices"));
    EXPECT_EQ(fault_of([](Input& input) { input.mesh.triangles[0].x = 0xffffffff; }).fault, Fault::bad_index);
}

TEST(Validate, NonFinitePosition) {
    for (const double bad : {nan, infinity, -infinity}) {
        const Status status = fault_of([bad](Input& input) { doubles(input.mesh.position)[3 * 5 + 1] = bad; });
        EXPECT_EQ(status.fault, Fault::non_finite_position);
        EXPECT_EQ(status.variable, "position");
        EXPECT_EQ(status.index, 5U);
        EXPECT_THAT(status.message, HasSubstr("vertex 5"));
        EXPECT_THAT(status.message, HasSubstr(std::isnan(bad) ? "not a number" : "infinite"));
    }
}

TEST(Validate, ValuesFartherApartThanADoubleHolds) {
    constexpr double largest = std::numeric_limits<double>::max();
    const Status data = fault_of([](Input& input) {
        doubles(input.mesh.variables[0])[4] = largest;
        doubles(input.mesh.variables[0])[5] = -largest;
    });
    EXPECT_EQ(data.fault, Fault::non_finite_value);
    EXPECT_EQ(data.variable, "heat");
    const Status position = fault_of([](Input& input) {
        doubles(input.mesh.position)[0] = largest;
        doubles(input.mesh.position)[3] = -largest;
        input.bounds = {{"*", unbounded()}};
    });
    EXPECT_EQ(position.fault, Fault::non_finite_position);
}

TEST(Validate, NonFiniteValue) {
    const Status scalar = fault_of([](Input& input) { doubles(input.mesh.variables[0])[4] = nan; });
    EXPECT_EQ(scalar.fault, Fault::non_finite_value);
    EXPECT_EQ(scalar.variable, "heat");
    EXPECT_EQ(scalar.index, 4U);
    EXPECT_THAT(scalar.message, HasSubstr("“heat”"));
    const Status vector = fault_of([](Input& input) { doubles(input.mesh.variables[1])[3 * 9 + 2] = infinity; });
    EXPECT_EQ(vector.fault, Fault::non_finite_value);
    EXPECT_EQ(vector.variable, "wind");
    EXPECT_EQ(vector.index, 9U) << "the vertex, not the number";
}

TEST(Validate, BadComponents) {
    for (const int bad : {0, -1, 100'000}) {
        const Status status = fault_of([bad](Input& input) { input.mesh.variables[1].components = bad; });
        EXPECT_EQ(status.fault, Fault::bad_components);
        EXPECT_EQ(status.variable, "wind");
        EXPECT_EQ(status.index, 1U);
        EXPECT_THAT(status.message, HasSubstr(std::to_string(bad)));
    }
}

TEST(Validate, WrongValueCount) {
    const Status fewer = fault_of([](Input& input) { doubles(input.mesh.variables[0]).resize(10); });
    EXPECT_EQ(fewer.fault, Fault::wrong_value_count);
    EXPECT_EQ(fewer.variable, "heat");
    EXPECT_EQ(fewer.index, 0U);
    EXPECT_THAT(fewer.message, HasSubstr("10"));
    EXPECT_THAT(fewer.message, HasSubstr("16"));
    EXPECT_EQ(fault_of([](Input& input) { doubles(input.mesh.variables[1]).push_back(0); }).fault,
              Fault::wrong_value_count);
    EXPECT_EQ(fault_of([](Input& input) { doubles(input.mesh.variables[1]).clear(); }).fault, Fault::wrong_value_count);
}

/// A plate with so many variables that say nothing, and a last one that holds its one inner vertex in place.
Mesh with_variables(std::size_t count) {
    Mesh mesh = meshes::plane(2, 2);
    for (std::size_t i = 1; i < count; ++i)
        mesh.variables.push_back({std::to_string(i), 1, std::vector<float>(vertex_count(mesh))});
    meshes::add_scalar(mesh, "last", [](glm::dvec3 p) { return p.x * p.x + p.y * p.y; });
    return mesh;
}

TEST(Validate, MoreVariablesThanCanBeNumbered) {
    constexpr std::size_t most = 65'535;
    const Status status = validate(with_variables(most + 1));
    EXPECT_EQ(status.fault, Fault::too_large);
    EXPECT_THAT(status.message, HasSubstr("has 65536 variables; at most 65535"));

    const Mesh mesh = with_variables(most);
    const Reduction reduction = guarantee::reduced(mesh, {{"last", relative(1e-3)}});
    EXPECT_EQ(reduction.report.variables.back().name, "last");
    EXPECT_GT(reduction.report.variables.back().refused, 0U) << "what the last one refuses counts for another";
}

TEST(Validate, EmptyName) {
    const Status status = fault_of([](Input& input) { input.mesh.variables[1].name = ""; });
    EXPECT_EQ(status.fault, Fault::empty_name);
    EXPECT_EQ(status.index, 1U);
    EXPECT_THAT(status.message, HasSubstr("1"));
}

TEST(Validate, DuplicateName) {
    for (const char* name : {"heat", "position", "*"}) {
        const Status status = fault_of([name](Input& input) { input.mesh.variables[1].name = name; });
        EXPECT_EQ(status.fault, Fault::duplicate_name);
        EXPECT_EQ(status.index, 1U);
        EXPECT_THAT(status.message, HasSubstr(std::string("“") + name + "”"));
    }
}

TEST(Validate, UnknownVariable) {
    const Status status = fault_of([](Input& input) { input.bounds.push_back({"haet", relative(0.1)}); });
    EXPECT_EQ(status.fault, Fault::unknown_variable);
    EXPECT_EQ(status.variable, "haet");
    EXPECT_THAT(status.message, HasSubstr("“haet”"));
}

TEST(Validate, BadBound) {
    for (const double bad : {0.0, -0.0, -0.5, nan, infinity, -infinity})
        for (const Bound& bound : {relative(bad), absolute(bad)})
            for (const char* name : {"position", "heat", "*"}) {
                const Status status = fault_of([&](Input& input) { input.bounds.push_back({name, bound}); });
                EXPECT_EQ(status.fault, Fault::bad_bound) << bad;
                EXPECT_EQ(status.variable, name);
                EXPECT_THAT(status.message, HasSubstr(std::string("“") + name + "”"));
            }
}

TEST(Validate, BoundTooFine) {
    const Status relative_bound = fault_of([](Input& input) { input.bounds.push_back({"heat", relative(1e-17)}); });
    EXPECT_EQ(relative_bound.fault, Fault::bound_too_fine);
    EXPECT_EQ(relative_bound.variable, "heat");
    EXPECT_THAT(relative_bound.message, HasSubstr("“heat”"));
    EXPECT_THAT(relative_bound.message, testing::Not(HasSubstr(" 0.000000"))) << "the bound is small, not zero";
    EXPECT_EQ(fault_of([](Input& input) {
                  input.bounds.push_back({"position", absolute(1e-300)});
              }).fault,
              Fault::bound_too_fine);
    EXPECT_EQ(fault_of([](Input& input) {
                  input.bounds.push_back({"position", absolute(5e-324)});
              }).fault,
              Fault::bound_too_fine);
}

TEST(Validate, BadSweeps) {
    const std::vector<std::vector<double>> bad = {{},       {0.5},    {1, 1}, {0, 1},   {-0.5, 1},     {0.5, 0.25, 1},
                                                  {0.5, 2}, {nan, 1}, {nan},  {1, nan}, {0.5, nan, 1}, {0.5, infinity}};
    for (const std::vector<double>& sweeps : bad) {
        const Status status = fault_of([&](Input& input) { input.options.sweeps = sweeps; });
        EXPECT_EQ(status.fault, Fault::bad_option) << testing::PrintToString(sweeps);
        EXPECT_THAT(status.message, HasSubstr("sweeps"));
    }
}

TEST(Validate, BadLockedVertex) {
    const Status status = fault_of([](Input& input) { input.options.locked = {3, 16}; });
    EXPECT_EQ(status.fault, Fault::bad_option);
    EXPECT_EQ(status.index, 1U);
    EXPECT_THAT(status.message, HasSubstr("16"));
}

TEST(Validate, NamesEveryFaultOnce) {
    std::set<std::string_view> names;
    for (int fault = 0; fault <= static_cast<int>(Fault::out_of_memory); ++fault)
        names.insert(fault_name(static_cast<Fault>(fault)));
    EXPECT_EQ(names.size(), static_cast<std::size_t>(Fault::out_of_memory) + 1);
    EXPECT_EQ(fault_name(Fault::none), "none");
    EXPECT_EQ(fault_name(Fault::bad_index), "bad_index");
    EXPECT_EQ(fault_name(Fault::bound_too_fine), "bound_too_fine");
    EXPECT_EQ(fault_name(Fault::out_of_memory), "out_of_memory");
}

TEST(Validate, CountsOddities) {
    Mesh mesh = meshes::plane(3, 3);
    doubles(mesh.position).insert(doubles(mesh.position).end(), {5, 5, 5, 6, 6, 6});
    mesh.triangles.push_back({0, 0, 1});
    mesh.triangles.push_back({2, 2, 2});
    mesh.triangles.push_back({0, 1, 2});
    MeshDefects defects;
    EXPECT_TRUE(validate(mesh, &defects).ok());
    EXPECT_EQ(defects.unused_vertices, 2U);
    EXPECT_EQ(defects.repeated_vertex_triangles, 2U);
    EXPECT_EQ(defects.zero_area_triangles, 1U);
}

TEST(Validate, FindsNoFaultInOddMeshes) {
    for (const Mesh& mesh : {meshes::three_sheets(4), meshes::bow_tie(4), meshes::cubes_on_one_edge(3),
                             meshes::one_triangle_reversed(4), meshes::with_degenerate_triangles(meshes::sphere(5))})
        EXPECT_TRUE(validate(mesh).ok());
}

TEST(ResolvedBounds, AreTakenFromTheExtent) {
    Input input;
    std::vector<ResolvedBound> resolved;
    ASSERT_TRUE(resolve_bounds(input.mesh, {{"position", relative(0.5)}, {"heat", absolute(3)}}, resolved).ok());
    ASSERT_EQ(resolved.size(), 3U);
    EXPECT_DOUBLE_EQ(resolved[0].extent, std::sqrt(2.0)) << "the diagonal of the unit square";
    EXPECT_DOUBLE_EQ(resolved[0].absolute, std::sqrt(0.5));
    EXPECT_EQ(resolved[1].absolute, 3);
    EXPECT_EQ(resolved[2].absolute, infinity) << "not named: free";
}

TEST(ResolvedBounds, TheLaterOfTwoEntriesHoldsAndNamesWinOverTheStar) {
    const Input input;
    std::vector<ResolvedBound> resolved;
    const Bounds bounds = {
        {"heat", absolute(1)}, {"heat", absolute(2)}, {"*", absolute(3)}, {"*", absolute(4)}, {"wind", unbounded()}};
    ASSERT_TRUE(resolve_bounds(input.mesh, bounds, resolved).ok());
    EXPECT_EQ(resolved[0].absolute, 4);
    EXPECT_EQ(resolved[1].absolute, 2);
    EXPECT_EQ(resolved[2].absolute, infinity);
    EXPECT_EQ(resolved[2].given.kind, Bound::Kind::free);
}

} // namespace
