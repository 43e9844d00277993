// The meshes of the tests are what they say they are.

#include <cmath>
#include <cstdio>
#include <fstream>
#include <numbers>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "meshbound/validate.hpp"
#include "meshes/defects.hpp"
#include "meshes/fields.hpp"
#include "meshes/ply.hpp"
#include "meshes/shapes.hpp"
#include "meshes/topology.hpp"
#include "meshes/variations.hpp"
#include "meshes/voxel_surface.hpp"

namespace {

using meshes::area_vector;
using meshes::enclosed_volume;
using meshes::Mesh;
using meshes::topology;
using meshes::Topology;

constexpr Topology closed(long genus, std::size_t components = 1) {
    return {2 * static_cast<long>(components) - 2 * genus, components, 0, 0, 0};
}
constexpr Topology open(long euler, std::size_t loops) { return {euler, 1, loops, 0, 0}; }

TEST(Meshes, HaveTheirTopology) {
    EXPECT_EQ(topology(meshes::plane(5, 4)), open(1, 1));
    EXPECT_EQ(topology(meshes::cube(4)), closed(0));
    EXPECT_EQ(topology(meshes::sphere(5)), closed(0));
    EXPECT_EQ(topology(meshes::noisy_sphere(5, 0.1, 1)), closed(0));
    EXPECT_EQ(topology(meshes::torus(12, 8)), closed(1));
    EXPECT_EQ(topology(meshes::cylinder(12, 5)), open(0, 2));
    EXPECT_EQ(topology(meshes::twisted_band(16, 4)), open(0, 2));
    EXPECT_EQ(topology(meshes::pleats(5, 4)), open(1, 1));
    EXPECT_EQ(topology(meshes::terrain(4, 7)), open(1, 1));
    for (int holes = 0; holes <= 3; ++holes) EXPECT_EQ(topology(meshes::pierced_plate(holes, 2)), closed(holes));
    EXPECT_EQ(topology(meshes::joined(meshes::cube(2), meshes::torus(8, 8))).components, 2U);
}

TEST(Meshes, AreOrientedOutwardOrUp) {
    EXPECT_NEAR(enclosed_volume(meshes::cube(3)), 1, 1e-12);
    EXPECT_NEAR(enclosed_volume(meshes::sphere(20)), 4.0 / 3 * std::numbers::pi, 0.05);
    EXPECT_NEAR(enclosed_volume(meshes::torus(60, 40, 0.4)), 2 * std::pow(std::numbers::pi * 0.4, 2), 0.1);
    EXPECT_NEAR(enclosed_volume(meshes::pierced_plate(2, 2)), 8 * 13, 1e-9);
    EXPECT_NEAR(area_vector(meshes::plane(3, 4, 2, 3)).z, 6, 1e-12);
    EXPECT_NEAR(area_vector(meshes::terrain(4, 3)).z, 1, 1e-12);
    EXPECT_NEAR(enclosed_volume(meshes::reversed(meshes::cube(3))), -1, 1e-12);
}

TEST(Meshes, KeepTheirSurfaceInVariations) {
    const Mesh cube = meshes::cube(5);
    const Mesh plane = meshes::plane(8, 8), flipped = meshes::flipped(plane, 500, 1);
    EXPECT_NE(flipped.triangles, plane.triangles);
    EXPECT_EQ(topology(flipped), topology(plane));
    EXPECT_NEAR(area_vector(flipped).z, 1, 1e-12);
    EXPECT_EQ(topology(meshes::flipped(cube, 500, 1)), topology(cube));
    const Mesh shuffled = meshes::shuffled(cube, 2);
    EXPECT_EQ(topology(shuffled), topology(cube));
    EXPECT_NEAR(enclosed_volume(shuffled), 1, 1e-12);
    EXPECT_NEAR(area_vector(meshes::jittered(meshes::plane(6, 6), 0.03, 1)).z, 1, 1e-12);
}

TEST(Meshes, AreOddInTheirOwnWay) {
    EXPECT_EQ(topology(meshes::three_sheets(4)).non_manifold_edges, 4U);
    EXPECT_EQ(topology(meshes::cubes_on_one_edge(3)).non_manifold_edges, 3U);
    EXPECT_EQ(topology(meshes::bow_tie(3)), open(1, 1)) << "two squares, one boundary figure-of-eight";
    EXPECT_EQ(topology(meshes::one_triangle_reversed(3)).discordant_edges, 3U);
    Mesh sphere = meshes::sphere(6);
    meshes::add_usual_fields(sphere);
    const Mesh degenerate = meshes::with_degenerate_triangles(sphere);
    EXPECT_EQ(topology(degenerate), topology(sphere));
    meshbound::MeshDefects defects;
    ASSERT_TRUE(meshbound::validate(degenerate, &defects).ok());
    EXPECT_GT(defects.zero_area_triangles, 10U);
}

TEST(Meshes, ComeBackFromAPlyFile) {
    const std::string path = ::testing::TempDir() + "meshbound_ply_test.ply";
    {
        std::ofstream file(path, std::ios::binary);
        file << "ply\nformat binary_little_endian 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
                "property float z\nproperty float heat\nelement face 1\nproperty list uchar int vertex_indices\n"
                "end_header\n";
        const float values[] = {0, 0, 0, 5, 1, 0, 0, 6, 0, 1, 0, 7};
        file.write(reinterpret_cast<const char*>(values), sizeof values);
        file.put(3);
        const std::uint32_t corners[] = {0, 1, 2};
        file.write(reinterpret_cast<const char*>(corners), sizeof corners);
    }
    const Mesh mesh = meshes::read_ply(path);
    std::remove(path.c_str());
    EXPECT_EQ(std::get<std::vector<float>>(mesh.position.values), (std::vector<float>{0, 0, 0, 1, 0, 0, 0, 1, 0}));
    ASSERT_EQ(mesh.variables.size(), 1U);
    EXPECT_EQ(mesh.variables[0].name, "heat");
    EXPECT_EQ(std::get<std::vector<float>>(mesh.variables[0].values), (std::vector<float>{5, 6, 7}));
    EXPECT_EQ(mesh.triangles, (std::vector<glm::uvec3>{{0, 1, 2}}));
}

} // namespace
