// A map that is not of the surfaces it is handed with, or that is damaged, is refused by name; whatever is not refused does no
// harm.

#include <cstdint>
#include <functional>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "guarantee.hpp"
#include "meshbound/meshbound.hpp"
#include "meshes/defects.hpp"
#include "meshes/fields.hpp"
#include "meshes/random.hpp"
#include "meshes/shapes.hpp"
#include "meshes/variations.hpp"

namespace {

using namespace meshbound;
using testing::HasSubstr;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// A mesh and its reduction, to be broken in one place.
struct Mapped {
    Mesh mesh;
    Reduction reduction;
};

Mapped mapped(Mesh mesh, const Bounds& bounds = guarantee::percent(2, 6)) {
    meshes::add_usual_fields(mesh);
    Reduction reduction = guarantee::reduced(mesh, bounds);
    return {std::move(mesh), std::move(reduction)};
}

const Mapped& sound() {
    static const Mapped plate = mapped(meshes::jittered(meshes::plane(12, 12), 0.01, 1));
    return plate;
}

/// Cuts a broken pair: it must be refused and touch nothing; and so must be the way to morph it.
Status refused(const std::function<void(Mapped&)>& break_it) {
    Mapped broken = sound();
    break_it(broken);
    Segmentation segmentation;
    segmentation.corners = {7};
    const Status status = segment({broken.mesh, broken.reduction}, segmentation);
    EXPECT_EQ(segmentation.corners, std::vector<std::uint32_t>{7}) << "touched";
    EXPECT_FALSE(status.ok());
    EXPECT_TRUE(status.message.ends_with('.')) << status.message;
    Morph morph;
    morph.folded_triangles = 7;
    EXPECT_EQ(make_morph({broken.mesh, broken.reduction}, morph).message, status.message);
    EXPECT_EQ(morph.folded_triangles, 7U) << "touched";
    return status;
}

void expect_bad_map(std::size_t index, const std::string& message, const std::function<void(Mapped&)>& break_it) {
    const Status status = refused(break_it);
    EXPECT_EQ(status.fault, Fault::bad_map) << status.message;
    EXPECT_EQ(status.index, index) << status.message;
    EXPECT_THAT(status.message, HasSubstr(message));
}

/// The first vertex that is gone.
std::uint32_t removed_vertex(const Mapped& pair) {
    std::uint32_t vertex = 0;
    while (pair.reduction.vertices[vertex] == vertex) ++vertex;
    return vertex;
}

/// The first of two crossings of one edge of the original.
std::size_t crossed_twice(const Mapped& pair) {
    const std::vector<MapCrossing>& crossings = pair.reduction.map.crossings;
    std::size_t n = 0;
    while (crossings[n].original != crossings[n + 1].original || crossings[n].s == crossings[n + 1].s) ++n;
    return n;
}

TEST(CheckMap, ASoundOneIsFine) {
    Segmentation segmentation;
    const Status status = segment({sound().mesh, sound().reduction}, segmentation);
    EXPECT_TRUE(status.ok()) << status.message;
    EXPECT_FALSE(segmentation.cells.empty());
    EXPECT_GT(sound().reduction.map.crossings.size(), 20U);
}

TEST(CheckMap, OfAnotherMesh) {
    Segmentation segmentation;
    const Mesh other = meshes::plane(11, 13);
    EXPECT_EQ(segment({other, sound().reduction}, segmentation).fault, Fault::bad_map);
    const Mapped same_size = mapped(meshes::jittered(meshes::plane(12, 12), 0.01, 2));
    Reduction mixed = sound().reduction;
    mixed.map = same_size.reduction.map;
    EXPECT_EQ(segment({sound().mesh, mixed}, segmentation).fault, Fault::bad_map);
    mixed = sound().reduction;
    mixed.vertices = same_size.reduction.vertices;
    EXPECT_EQ(segment({sound().mesh, mixed}, segmentation).fault, Fault::bad_map);
}

TEST(CheckMap, Counts) {
    Status status = refused([](Mapped& broken) { broken.reduction.map.images.pop_back(); });
    EXPECT_EQ(status.fault, Fault::bad_map);
    EXPECT_THAT(status.message, HasSubstr("168 images, but the original has 169 vertices"));
    status = refused([](Mapped& broken) { broken.reduction.map.images.clear(); });
    EXPECT_EQ(status.fault, Fault::bad_map);
    status = refused([](Mapped& broken) { broken.reduction.vertices.pop_back(); });
    EXPECT_EQ(status.fault, Fault::bad_map);
    EXPECT_THAT(status.message, HasSubstr("where they come from"));
}

TEST(CheckMap, SurfacesThatAreNone) {
    Status status = refused([](Mapped& broken) { broken.reduction.mesh.triangles[1].y = 1U << 30; });
    EXPECT_EQ(status.fault, Fault::bad_index);
    EXPECT_EQ(status.index, 1U);
    EXPECT_THAT(status.message, HasSubstr("Of the reduced mesh: Triangle 1 names vertex 1073741824"));
    status = refused([](Mapped& broken) { broken.mesh.triangles[5].z = 169; });
    EXPECT_EQ(status.fault, Fault::bad_index);
    EXPECT_EQ(status.index, 5U);
    EXPECT_THAT(status.message, HasSubstr("Of the original: Triangle 5 names vertex 169"));
    EXPECT_EQ(refused([](Mapped& broken) { broken.mesh.regions = {1}; }).fault, Fault::wrong_value_count);
}

TEST(CheckMap, Vertices) {
    expect_bad_map(2, "which has 169 vertices (counted from 0)",
                   [](Mapped& broken) { broken.reduction.vertices[2] = 169; });
    expect_bad_map(1, "they must rise",
                   [](Mapped& broken) { std::swap(broken.reduction.vertices[0], broken.reduction.vertices[1]); });
    expect_bad_map(removed_vertex(sound()), "elsewhere", [](Mapped& broken) {
        const std::uint32_t gone = removed_vertex(broken);
        broken.reduction.vertices[gone] = gone; // in place of the next one that is kept
    });
}

TEST(CheckMap, Places) {
    const std::uint32_t gone = removed_vertex(sound());
    const auto move = [gone](std::function<void(SurfacePoint&)> change) {
        return [gone, change](Mapped& broken) { change(broken.reduction.map.images[gone]); };
    };
    const std::string triangles = std::to_string(sound().reduction.mesh.triangles.size());
    expect_bad_map(gone, "into triangle 100000, but the reduced mesh has " + triangles + " triangles (counted from 0)",
                   move([](SurfacePoint& place) { place.triangle = 100'000; }));
    for (const glm::dvec3& w : {glm::dvec3(0.5, 0.5, 0.5), glm::dvec3(2, -1, 0), glm::dvec3(nan, 1, 0)})
        expect_bad_map(gone, "barycentric", move([w](SurfacePoint& place) { place.barycentric = w; }));
    const Status status = refused(move([](SurfacePoint& place) { place.triangle = nowhere; }));
    EXPECT_THAT(status.message, HasSubstr("none for others"));
    EXPECT_EQ(status.fault, Fault::bad_map);
    EXPECT_TRUE(status.index.has_value());
    const std::uint32_t kept = sound().reduction.vertices[3];
    expect_bad_map(kept, "elsewhere than at vertex 3 of the reduced mesh", [kept](Mapped& broken) {
        broken.reduction.map.images[kept].barycentric = {0.5, 0.25, 0.25};
    });
    expect_bad_map(kept, "elsewhere", [kept](Mapped& broken) { broken.reduction.map.images[kept].triangle = nowhere; });
}

TEST(CheckMap, Crossings) {
    const auto change = [](std::function<void(MapCrossing&)> spoil) {
        return [spoil](Mapped& broken) { spoil(broken.reduction.map.crossings[3]); };
    };
    expect_bad_map(3, "edge 3-169 of the original", change([](MapCrossing& x) { x.original = {3, 169}; }));
    expect_bad_map(3, "the lower one comes first",
                   change([](MapCrossing& x) { std::swap(x.original.x, x.original.y); }));
    expect_bad_map(3, "edge 0-70000", change([](MapCrossing& x) { x.reduced = {0, 70'000}; }));
    expect_bad_map(3, "edge 0-0", change([](MapCrossing& x) { x.reduced = {0, 0}; }));
    for (const double bad : {-0.1, 1.1, nan}) {
        expect_bad_map(3, "both must be 0 to 1", change([bad](MapCrossing& x) { x.s = bad; }));
        expect_bad_map(3, "both must be 0 to 1", change([bad](MapCrossing& x) { x.t = bad; }));
    }
    const std::size_t twice = crossed_twice(sound());
    expect_bad_map(twice + 1, "they must rise", [twice](Mapped& broken) {
        std::swap(broken.reduction.map.crossings[twice].s, broken.reduction.map.crossings[twice + 1].s);
    });
    const std::size_t count = sound().reduction.map.crossings.size();
    expect_bad_map(count, "edge 0-168, which no mapped triangle of the original has", [](Mapped& broken) {
        MapCrossing stray = broken.reduction.map.crossings.back();
        stray.original = {0, 168};
        broken.reduction.map.crossings.push_back(stray);
    });
}

TEST(CheckMap, CellsThatDoNotFit) {
    for (const auto& tear : std::vector<std::function<void(std::vector<MapCrossing>&)>>{
             [](std::vector<MapCrossing>& crossings) { crossings.erase(crossings.begin() + 3); },
             [](std::vector<MapCrossing>& crossings) { crossings.clear(); },
             [](std::vector<MapCrossing>& crossings) { crossings[3].reduced = crossings.back().reduced; }}) {
        const Status status = refused([&](Mapped& broken) { tear(broken.reduction.map.crossings); });
        EXPECT_EQ(status.fault, Fault::bad_map);
        EXPECT_THAT(status.message, HasSubstr("fits no triangle of the reduced mesh"));
        EXPECT_TRUE(status.index.has_value());
    }
}

TEST(CheckMap, VariablesThatCannotBeMorphed) {
    const auto fault = [](const std::function<void(Mesh&)>& spoil) {
        Mapped broken = sound();
        spoil(broken.reduction.mesh);
        Morph morph;
        const Status status = make_morph({broken.mesh, broken.reduction}, morph);
        EXPECT_EQ(status.fault, Fault::bad_map) << status.message;
        return status.variable;
    };
    const std::string last = sound().mesh.variables.back().name;
    EXPECT_EQ(fault([](Mesh& mesh) { mesh.variables.pop_back(); }), last);
    EXPECT_EQ(fault([](Mesh& mesh) { mesh.variables.back().name = "other"; }), last);
    EXPECT_EQ(fault([](Mesh& mesh) {
                  const std::vector<double> values(vertex_count(mesh) * 3);
                  mesh.position.values = std::vector<float>(values.begin(), values.end());
              }),
              "position");
}

/// Everything that can be read of a segmentation is there.
void expect_harmless(const MappedSurfaces& surfaces, const Segmentation& segmentation) {
    const std::size_t corners = surfaces.map.images.size() + surfaces.map.crossings.size();
    for (const SegmentationCell& cell : segmentation.cells) {
        ASSERT_LT(cell.original, surfaces.original.triangles.size());
        ASSERT_LT(cell.reduced, surfaces.reduced.triangles.size());
        ASSERT_LE(cell.first_corner + cell.corner_count, segmentation.corners.size());
        ASSERT_LE(cell.first_piece + cell.corner_count - 2, segmentation.pieces.size());
    }
    for (const std::uint32_t corner : segmentation.corners) ASSERT_LT(corner, corners);
    for (const glm::uvec3& piece : segmentation.pieces)
        for (int i = 0; i < 3; ++i) ASSERT_LT(piece[i], corners);
}

/// An index that is likely, or not at all.
std::uint32_t some_index(meshes::Random& random, std::uint32_t now, std::size_t count) {
    switch (random.below(5)) {
    case 0: return now + 1;
    case 1: return now - 1;
    case 2: return static_cast<std::uint32_t>(random.below(count));
    case 3: return static_cast<std::uint32_t>(random.next());
    default: return static_cast<std::uint32_t>(count);
    }
}

double some_number(meshes::Random& random) {
    const double numbers[] = {0, 1, -1, 0.5, nan, 1e300, random.uniform(0, 1)};
    return numbers[random.below(std::size(numbers))];
}

/// Elements go, come twice or change places.
template <class T>
void shuffle(meshes::Random& random, std::vector<T>& list) {
    const auto at = list.begin() + static_cast<std::ptrdiff_t>(random.below(list.size()));
    switch (random.below(3)) {
    case 0: list.erase(at); break;
    case 1: list.insert(at, list[random.below(list.size())]); break;
    default: std::swap(*at, list[random.below(list.size())]);
    }
}

void spoil_places(meshes::Random& random, Mapped& pair) {
    std::vector<SurfacePoint>& places = pair.reduction.map.images;
    SurfacePoint& place = places[random.below(places.size())];
    switch (random.below(4)) {
    case 0: place.triangle = some_index(random, place.triangle, pair.reduction.mesh.triangles.size()); break;
    case 1: place.barycentric[static_cast<int>(random.below(3))] = some_number(random); break;
    case 2: std::swap(place.barycentric.x, place.barycentric.y); break;
    default: shuffle(random, places);
    }
}

void spoil_crossings(meshes::Random& random, Mapped& pair) {
    std::vector<MapCrossing>& crossings = pair.reduction.map.crossings;
    MapCrossing& crossing = crossings[random.below(crossings.size())];
    const int end = static_cast<int>(random.below(2));
    switch (random.below(7)) {
    case 0: crossing.original[end] = some_index(random, crossing.original[end], vertex_count(pair.mesh)); break;
    case 1: crossing.reduced[end] = some_index(random, crossing.reduced[end], pair.reduction.vertices.size()); break;
    case 2: crossing.rightward = !crossing.rightward; break;
    case 3: (end ? crossing.s : crossing.t) = some_number(random); break;
    case 4: crossing.reduced = crossings[random.below(crossings.size())].reduced; break;
    case 5: std::swap(crossing.reduced.x, crossing.reduced.y); break;
    default: shuffle(random, crossings);
    }
}

void spoil_triangles(meshes::Random& random, Mesh& mesh) {
    std::uint32_t& corner = mesh.triangles[random.below(mesh.triangles.size())][static_cast<int>(random.below(3))];
    if (random.below(2) == 0) corner = some_index(random, corner, vertex_count(mesh));
    else shuffle(random, mesh.triangles);
}

void spoil(meshes::Random& random, Mapped& pair) {
    std::vector<std::uint32_t>& vertices = pair.reduction.vertices;
    std::uint32_t& vertex = vertices[random.below(vertices.size())];
    switch (random.below(6)) {
    case 0: spoil_places(random, pair); break;
    case 1:
    case 2: spoil_crossings(random, pair); break;
    case 3:
        if (random.below(2) == 0) vertex = some_index(random, vertex, vertex_count(pair.mesh));
        else shuffle(random, vertices);
        break;
    case 4: spoil_triangles(random, pair.mesh); break;
    default: spoil_triangles(random, pair.reduction.mesh);
    }
}

Mesh in_halves(Mesh mesh) {
    for (const glm::uvec3& t : mesh.triangles) mesh.regions.push_back(meshes::point(mesh, t.x).x < 0 ? 3 : 7);
    return mesh;
}

TEST(CheckMap, WhateverIsDamagedIsRefusedOrHarmless) {
    const std::vector<Mapped> pairs = {sound(), mapped(meshes::noisy_sphere(8, 0.05, 1)),
                                       mapped(in_halves(meshes::sphere(8)), guarantee::percent(4, 12)),
                                       mapped(meshes::three_sheets(8)), mapped(meshes::torus(24, 12))};
    constexpr std::size_t rounds = 4000;
    std::size_t refusals = 0;
    for (std::size_t seed = 0; seed < rounds; ++seed) {
        SCOPED_TRACE(seed);
        meshes::Random random(seed);
        Mapped broken = pairs[seed % pairs.size()];
        for (std::size_t times = 1 + random.below(3); times > 0; --times) spoil(random, broken);
        Segmentation segmentation;
        Morph morph;
        const MappedSurfaces surfaces{broken.mesh, broken.reduction};
        const Status status = segment(surfaces, segmentation);
        const Status morphing = make_morph(surfaces, morph);
        if (status.ok()) expect_harmless(surfaces, segmentation);
        else EXPECT_FALSE(status.message.empty());
        if (morphing.ok()) morphed(morph, 0.5);
        refusals += !status.ok();
    }
    RecordProperty("refusals", static_cast<int>(refusals));
    EXPECT_GT(refusals, rounds / 2);
    EXPECT_LT(refusals, rounds);
}

} // namespace
