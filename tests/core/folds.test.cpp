// No triangle turns more than a right angle against the surface that it stands for, unless the original does there.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <set>
#include <vector>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "guarantee.hpp"
#include "meshes/gallery.hpp"
#include "meshes/shapes.hpp"
#include "meshes/variations.hpp"
#include "modes.hpp"

namespace {

using namespace meshbound;

/// A cosine this near to zero is a right angle, as far as double precision can tell.
constexpr double right_angle = 1e-9;

glm::dvec3 area_vector(const Mesh& mesh, const glm::uvec3& t) {
    const glm::dvec3 first = meshes::point(mesh, t.x);
    return glm::cross(meshes::point(mesh, t.y) - first, meshes::point(mesh, t.z) - first);
}

glm::dvec3 unit(const glm::dvec3& v) { return glm::length(v) > 0 ? v / glm::length(v) : v; }

std::vector<glm::dvec3> vertex_normals(const Mesh& mesh) {
    std::vector<glm::dvec3> normals(vertex_count(mesh), glm::dvec3(0));
    for (const glm::uvec3& t : mesh.triangles)
        for (int i = 0; i < 3; ++i) normals[t[i]] += area_vector(mesh, t);
    for (glm::dvec3& normal : normals) normal = unit(normal);
    return normals;
}

/// How a triangle between vertices of the original, seen from there, is turned against it.
double cosine(const Mesh& mesh, const std::vector<glm::dvec3>& normals, const glm::uvec3& t) {
    return glm::dot(unit(area_vector(mesh, t)), unit(normals[t.x] + normals[t.y] + normals[t.z]));
}

/// What the reduced triangles are called in the original.
std::vector<glm::uvec3> in_original(const Reduction& reduction) {
    std::vector<glm::uvec3> triangles;
    for (const glm::uvec3& t : reduction.mesh.triangles)
        triangles.emplace_back(reduction.vertices[t.x], reduction.vertices[t.y], reduction.vertices[t.z]);
    return triangles;
}

/// How many turn more than a right angle, at least and at most.
std::array<std::size_t, 2> count_turned(const Mesh& mesh, const std::vector<glm::uvec3>& triangles) {
    const std::vector<glm::dvec3> normals = vertex_normals(mesh);
    const auto below = [&](double limit) {
        return static_cast<std::size_t>(std::count_if(
            triangles.begin(), triangles.end(), [&](const glm::uvec3& t) { return cosine(mesh, normals, t) < limit; }));
    };
    return {below(-right_angle), below(right_angle)};
}

void expect_count(std::size_t count, const std::array<std::size_t, 2>& limits) {
    EXPECT_GE(count, limits[0]);
    EXPECT_LE(count, limits[1]);
}

class FoldsTest : public ModeTest {};
EVERY_MODE(FoldsTest);

TEST_P(FoldsTest, NoTriangleTurnsFartherThanTheOriginalAtItsCorners) {
    for (const meshes::Exhibit& exhibit : meshes::gallery()) {
        SCOPED_TRACE(exhibit.name);
        const Mesh& mesh = exhibit.mesh;
        const Reduction reduction = guarantee::reduced(mesh, guarantee::percent(2, 10), GetParam().options());
        const std::vector<glm::dvec3> normals = vertex_normals(mesh);
        std::vector<double> least(normals.size(), 0);
        for (const glm::uvec3& t : mesh.triangles)
            for (int i = 0; i < 3; ++i) least[t[i]] = std::min(least[t[i]], cosine(mesh, normals, t));
        for (const glm::uvec3& t : in_original(reduction))
            EXPECT_GE(cosine(mesh, normals, t), std::min({least[t.x], least[t.y], least[t.z]}) - right_angle);
    }
}

TEST_P(FoldsTest, AreCountedBeforeAndAfter) {
    std::size_t before = 0;
    for (const meshes::Exhibit& exhibit : meshes::gallery()) {
        SCOPED_TRACE(exhibit.name);
        const Reduction reduction = guarantee::reduced(exhibit.mesh, guarantee::percent(2, 10), GetParam().options());
        expect_count(reduction.report.flipped_normals_before, count_turned(exhibit.mesh, exhibit.mesh.triangles));
        expect_count(reduction.report.flipped_normals_after, count_turned(exhibit.mesh, in_original(reduction)));
        before += reduction.report.flipped_normals_before;
    }
    EXPECT_GT(before, 0U);
}

/// Coarse bounds tempt most; a sphere has no fold to begin with.
TEST_P(FoldsTest, NeverComeAboutOnASphere) {
    const Mesh mesh = meshes::sphere(12);
    for (const double percent : {0.3, 1.0, 3.0, 10.0}) {
        SCOPED_TRACE(percent);
        const Reduction reduction =
            guarantee::reduced(mesh, {{"position", relative(percent / 100)}}, GetParam().options());
        EXPECT_EQ(reduction.report.flipped_normals_before, 0U);
        EXPECT_EQ(reduction.report.flipped_normals_after, 0U);
        EXPECT_EQ(count_turned(mesh, in_original(reduction))[0], 0U);
    }
}

} // namespace
