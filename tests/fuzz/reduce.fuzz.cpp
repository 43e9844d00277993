// Feeds the core meshes, bounds and options that nobody would make on purpose. Whatever comes in, a reduction ends with a
// fault that has a message, or with a surface of the same topology that keeps its promise as its own map tells it; levels
// of detail nest besides, and morphs between them hang together.
//
//     build/fuzz/tests/reduce_fuzz -max_total_time=60

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <string>

#include "meshbound/meshbound.hpp"
#include "meshes/topology.hpp"

using namespace meshbound;

namespace {

/// Reads the fuzzer's bytes as whatever is wanted next; zeros when they are used up.
class Bytes {
public:
    Bytes(const std::uint8_t* data, std::size_t size) : data_(data), left_(size) {}

    std::uint8_t byte() {
        if (left_ == 0) return 0;
        --left_;
        return *data_++;
    }

    double raw_double() {
        std::uint8_t bytes[8];
        for (std::uint8_t& b : bytes) b = byte();
        double value = 0;
        std::memcpy(&value, bytes, sizeof value);
        return value;
    }

    /// Mostly small whole numbers, so that vertices coincide and lie on lines; sometimes very large, very small or any bits.
    double number() {
        const std::uint8_t kind = byte();
        const double small = static_cast<signed char>(byte()) / 8.0;
        switch (kind % 16) {
        case 0: return small * 1e30;
        case 1: return small * 1e-30;
        case 2: return small + 1e6;
        case 3: return raw_double();
        default: return small;
        }
    }

private:
    const std::uint8_t* data_;
    std::size_t left_;
};

void require(bool condition, const char* what) {
    if (condition) return;
    std::fprintf(stderr, "broken: %s\n", what);
    std::abort();
}

Variable make_variable(Bytes& bytes, std::string name, int components, std::size_t vertices) {
    std::vector<double> values;
    for (std::size_t i = 0; i < vertices * static_cast<std::size_t>(components); ++i) values.push_back(bytes.number());
    if (bytes.byte() % 2) return {std::move(name), components, std::vector<float>(values.begin(), values.end())};
    return {std::move(name), components, std::move(values)};
}

/// A piece of a grid, whose triangles fit together, with some corners then moved anywhere.
void add_grid(Bytes& bytes, Mesh& mesh, std::uint32_t columns, std::uint32_t rows) {
    for (std::uint32_t y = 0; y + 1 < rows; ++y)
        for (std::uint32_t x = 0; x + 1 < columns; ++x) {
            const std::uint32_t corner = y * columns + x;
            mesh.triangles.push_back({corner, corner + 1, corner + columns + 1});
            mesh.triangles.push_back({corner, corner + columns + 1, corner + columns});
        }
    for (int changes = bytes.byte() % 8; changes > 0 && !mesh.triangles.empty(); --changes)
        mesh.triangles[bytes.byte() % mesh.triangles.size()][bytes.byte() % 3] = bytes.byte() % (columns * rows + 1);
}

Mesh make_mesh(Bytes& bytes) {
    Mesh mesh;
    const std::uint32_t columns = 2 + bytes.byte() % 6, rows = 2 + bytes.byte() % 6;
    const std::uint32_t vertices = columns * rows;
    if (bytes.byte() % 4) add_grid(bytes, mesh, columns, rows);
    for (int extra = bytes.byte() % 16; extra > 0; --extra)
        mesh.triangles.push_back({bytes.byte() % vertices, bytes.byte() % vertices, bytes.byte() % vertices});
    mesh.position = make_variable(bytes, "position", 3, vertices);
    for (int i = bytes.byte() % 3; i > 0; --i)
        mesh.variables.push_back(make_variable(bytes, "v" + std::to_string(i), 1 + bytes.byte() % 3, vertices));
    return mesh;
}

Bound make_bound(Bytes& bytes) {
    switch (bytes.byte() % 4) {
    case 0: return free_of_bound();
    case 1: return absolute(bytes.number());
    default: return relative((1 + bytes.byte()) / 256.0);
    }
}

Options make_options(Bytes& bytes, std::size_t vertices) {
    Options options;
    const std::uint8_t bits = bytes.byte();
    options.errors = bits & 1 ? Errors::propagated : Errors::tracked;
    options.cost = bits & 2 ? Cost::maximum : Cost::introduced;
    options.choose_places = !(bits & 4);
    options.choose_crossings = !(bits & 8);
    for (int i = bytes.byte() % 3; i > 0; --i)
        options.locked.push_back(bytes.byte() % static_cast<std::uint32_t>(vertices));
    return options;
}

void check_subset(const Mesh& mesh, const Reduction& reduction) {
    for (std::size_t i = 1; i < reduction.vertices.size(); ++i)
        require(reduction.vertices[i - 1] < reduction.vertices[i], "vertices rise");
    require(gather(mesh.position, reduction.vertices).values == reduction.mesh.position.values,
            "positions bit for bit");
    for (std::size_t i = 0; i < mesh.variables.size(); ++i)
        require(gather(mesh.variables[i], reduction.vertices).values == reduction.mesh.variables[i].values,
                "values bit for bit");
}

void check_map(const Reduction& reduction) {
    for (const MapPlace& place : reduction.map.places) {
        if (place.triangle == nowhere) continue;
        require(place.triangle < reduction.mesh.triangles.size(), "places lie in triangles");
        const glm::dvec3& w = place.barycentric;
        require(w.x >= -1e-15 && w.y >= 0 && w.z >= 0 && std::abs(w.x + w.y + w.z - 1) < 1e-12,
                "places are barycentric");
    }
    for (const MapCrossing& crossing : reduction.map.crossings)
        require(crossing.s >= 0 && crossing.s <= 1 && crossing.t >= 0 && crossing.t <= 1,
                "crossings lie on their edges");
}

/// Several sheets shorten a common curve at once, and triangles on the wrong side are turned: odd edges may become fewer.
void check_topology(const meshes::Topology& before, const meshes::Topology& after) {
    require(after.euler == before.euler, "the Euler number is kept");
    require(after.components == before.components, "components are kept");
    require(after.boundary_loops == before.boundary_loops, "boundary loops are kept");
    require(after.non_manifold_edges <= before.non_manifold_edges, "no edge of three triangles comes about");
    require(after.discordant_edges <= before.discordant_edges, "no triangle turns to the wrong side");
}

void check_reduction(const Mesh& mesh, const Reduction& reduction) {
    for (const VariableReport& variable : reduction.report.variables) require(variable.ratio <= 1, "bounds are kept");
    check_subset(mesh, reduction);
    check_map(reduction);
    require(validate(reduction.mesh).ok(), "the result is valid");
    check_topology(meshes::topology(mesh), meshes::topology(reduction.mesh));
}

/// Bounds that are looser by a factor; a bound that makes no sense stays as it is.
Bounds looser(Bounds bounds, double factor) {
    for (NamedBound& entry : bounds) entry.bound.value *= factor;
    return bounds;
}

void check_morph(const Morph& morph) {
    for (const MorphEnd* end : {&morph.finer, &morph.coarser}) {
        require(end->triangles.size() == morph.triangles.size(), "every piece lies in a triangle");
        for (const glm::uvec3& triangle : morph.triangles)
            for (int i = 0; i < 3; ++i) require(triangle[i] < end->places.size(), "corners exist");
        for (const MorphPlace& place : end->places) {
            const glm::dvec3& w = place.weights;
            require(std::abs(w.x + w.y + w.z - 1) < 1e-12, "places are mixtures");
        }
    }
}

void check_levels(const Mesh& mesh, const Bounds& bounds, const Options& options, double factor) {
    Levels levels;
    const LevelOptions all{options, true, true};
    const Status status = reduce_levels(mesh, {bounds, looser(bounds, factor)}, all, levels);
    if (!status.ok()) {
        require(!status.message.empty(), "faults have a message");
        return;
    }
    for (const Reduction& level : levels.levels) check_reduction(mesh, level);
    for (const std::uint32_t vertex : levels.levels[1].vertices) {
        const std::vector<std::uint32_t>& finer = levels.levels[0].vertices;
        require(std::binary_search(finer.begin(), finer.end(), vertex), "levels nest");
    }
    for (const Morph& morph : levels.morphs) check_morph(morph);
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    Bytes bytes(data, size);
    const Mesh mesh = make_mesh(bytes);
    const Bounds bounds = {{"position", make_bound(bytes)}, {"*", make_bound(bytes)}};
    const Options options = make_options(bytes, vertex_count(mesh));
    Reduction reduction;
    const Status status = reduce(mesh, bounds, options, reduction);
    if (!status.ok()) {
        require(!status.message.empty(), "faults have a message");
        return 0;
    }
    check_reduction(mesh, reduction);
    if (const std::uint8_t coarser = bytes.byte()) check_levels(mesh, bounds, options, 1 + coarser / 16.0);
    return 0;
}
