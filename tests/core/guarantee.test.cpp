// The guarantee over every kind of surface: the independent judge agrees.

#include <cmath>
#include <vector>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "guarantee.hpp"
#include "meshes/fields.hpp"
#include "meshes/gallery.hpp"
#include "meshes/random.hpp"
#include "meshes/shapes.hpp"
#include "meshes/variations.hpp"
#include "meshes/voxel_surface.hpp"
#include "modes.hpp"

namespace {

using namespace meshbound;

class Guarantee : public ModeTest {};
EVERY_MODE(Guarantee);

void expect_guarantee_over_gallery(const Mode& mode, const Bounds& bounds) {
    for (const meshes::Exhibit& exhibit : meshes::gallery()) {
        SCOPED_TRACE(exhibit.name);
        const Reduction reduction = guarantee::reduced(exhibit.mesh, bounds, mode.options());
        guarantee::expect_everything(exhibit.mesh, reduction);
        if (!exhibit.closed) continue;
        EXPECT_GT(meshes::enclosed_volume(exhibit.mesh) * meshes::enclosed_volume(reduction.mesh), 0)
            << "turned inside out";
    }
}

TEST_P(Guarantee, HoldsAtTightBounds) { expect_guarantee_over_gallery(GetParam(), guarantee::percent(0.1, 1)); }
TEST_P(Guarantee, HoldsAtUsualBounds) { expect_guarantee_over_gallery(GetParam(), guarantee::percent(1, 3)); }
TEST_P(Guarantee, HoldsAtLooseBounds) { expect_guarantee_over_gallery(GetParam(), guarantee::percent(6, 6)); }

TEST_P(Guarantee, RemovesSomething) {
    for (const meshes::Exhibit& exhibit : meshes::gallery()) {
        SCOPED_TRACE(exhibit.name);
        const Bounds bounds = {{"position", relative(0.06)}};
        const Reduction reduction = guarantee::reduced(exhibit.mesh, bounds, GetParam().options());
        EXPECT_LT(reduction.mesh.triangles.size(), exhibit.mesh.triangles.size() / 2);
    }
}

/// A bound of any kind, from next to nothing to more than everything.
Bound random_bound(meshes::Random& random) {
    const double fraction = std::pow(10.0, random.uniform(-5, 0.3));
    switch (random.below(4)) {
    case 0: return unbounded();
    case 1: return absolute(fraction);
    default: return relative(fraction);
    }
}

/// Closed, of genus 0 to 3.
Mesh random_closed_surface(meshes::Random& random, std::uint64_t seed) {
    const double noise = random.uniform(0, 0.1);
    const auto genus = static_cast<int>(random.below(4));
    if (genus == 0) return meshes::noisy_sphere(6, noise, seed);
    const Mesh plain = genus == 1 ? meshes::torus(20, 10, random.uniform(0.1, 0.9)) : meshes::pierced_plate(genus, 2);
    return meshes::jittered(plain, noise, seed);
}

/// Closed as it was, or with one or two holes: without the triangles at a vertex, and at the one farthest from it.
Mesh perhaps_opened(const Mesh& mesh, meshes::Random& random) {
    const std::size_t holes = random.below(3);
    const std::size_t first = random.below(vertex_count(mesh));
    std::size_t other = first;
    const auto distance = [&](std::size_t v) {
        return glm::distance(meshes::point(mesh, v), meshes::point(mesh, first));
    };
    for (std::size_t v = 0; v < vertex_count(mesh); ++v)
        if (distance(v) > distance(other)) other = v;
    Mesh opened = mesh;
    std::erase_if(opened.triangles, [&](const glm::uvec3& t) {
        const auto has = [&t](std::size_t v) { return t.x == v || t.y == v || t.z == v; };
        return (holes > 0 && has(first)) || (holes > 1 && has(other));
    });
    return opened;
}

TEST_P(Guarantee, HoldsForRandomSurfacesAndBounds) {
    for (std::uint64_t seed = 0; seed < 60; ++seed) {
        SCOPED_TRACE(seed);
        meshes::Random random(seed);
        const Mesh plain = seed % 3 == 0 ? meshes::terrain(4, seed, random.uniform(0.3, 0.7))
                                         : perhaps_opened(random_closed_surface(random, seed), random);
        Mesh mesh = meshes::flipped(plain, random.below(1000), seed);
        meshes::add_usual_fields(mesh);
        mesh = meshes::shuffled(mesh, seed);
        if (random.below(2) == 0) mesh = meshes::in_single(mesh);
        Bounds bounds = {{"position", random_bound(random)}};
        for (const Variable& variable : mesh.variables) bounds.push_back({variable.name, random_bound(random)});
        guarantee::expect_everything(mesh, guarantee::reduced(mesh, bounds, GetParam().options()), 5'000);
    }
}

TEST_P(Guarantee, SurvivesTighteningOfAnyBoundAndAddingOfAnyVariable) {
    const std::vector<meshes::Exhibit> gallery = meshes::gallery();
    for (std::size_t i = 0; i < gallery.size(); i += 3) {
        SCOPED_TRACE(gallery[i].name);
        Mesh mesh = gallery[i].mesh;
        mesh.variables.clear();
        Bounds bounds = {{"position", relative(0.05)}};
        for (const Variable& variable : gallery[i].mesh.variables) {
            mesh.variables.push_back(variable);
            bounds.push_back({variable.name, relative(0.05)});
            guarantee::expect_everything(mesh, guarantee::reduced(mesh, bounds, GetParam().options()), 5'000);
            bounds.back().bound = relative(0.005);
            guarantee::expect_everything(mesh, guarantee::reduced(mesh, bounds, GetParam().options()), 5'000);
        }
    }
}

} // namespace
