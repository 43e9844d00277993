#include "fuzz/inputs.hpp"

#include <algorithm>
#include <cstring>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <glm/common.hpp>

namespace fuzz {
namespace {

using namespace meshbound;

Variable make_variable(Bytes& bytes, std::string name, int components, std::size_t vertices) {
    std::vector<double> values;
    for (std::size_t i = 0; i < vertices * static_cast<std::size_t>(components); ++i) values.push_back(bytes.number());
    if (bytes.byte() % 2) return {std::move(name), components, std::vector<float>(values.begin(), values.end())};
    return {std::move(name), components, std::move(values)};
}

/// What multiplies the bounds, mostly as it must be: above zero, from vertex to vertex up to 256 times as much.
Variable make_focus(Bytes& bytes, std::size_t vertices) {
    std::vector<double> values;
    for (std::size_t i = 0; i < vertices; ++i) values.push_back((1 + bytes.byte()) / 64.0);
    if (bytes.once_in(32)) values.front() = bytes.number();
    return {"focus", 1, std::move(values)};
}

/// The points of a grid, moved a little: a surface with much to reduce. Without bytes it is flat.
Variable make_terrain(Bytes& bytes, std::uint32_t columns, std::uint32_t rows) {
    constexpr double rise = 1.0 / 64, shift = 1.0 / 512; // a byte moves a point by less than half a cell
    std::vector<double> values;
    for (std::uint32_t y = 0; y < rows; ++y)
        for (std::uint32_t x = 0; x < columns; ++x)
            values.insert(values.end(), {x + bytes.signed_byte() * shift, y + bytes.signed_byte() * shift,
                                         bytes.signed_byte() * rise});
    return {"position", 3, std::move(values)};
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

/// Lays triangles on others: copies, whichever corner they begin at, and other sides.
void add_coincident(Bytes& bytes, Mesh& mesh) {
    if (mesh.triangles.empty()) return;
    const std::size_t first = bytes.byte() % mesh.triangles.size(), count = bytes.byte();
    const std::size_t last = std::min(first + count, mesh.triangles.size());
    const std::uint8_t kinds = bytes.byte(); // all of one kind, or by the triangle
    for (std::size_t n = first; n < last; ++n) {
        const glm::uvec3 t = mesh.triangles[n];
        const std::uint8_t kind = kinds % 4 < 3 ? kinds % 4 : bytes.byte() % 3;
        if (kind != 1) mesh.triangles.push_back({t.x, t.z, t.y});
        if (kind != 0) mesh.triangles.push_back({t.y, t.z, t.x});
    }
}

/// Gives some of the triangles vertices of their own in the places of the others'. By new vertex the one it stands on.
std::vector<std::uint32_t> part_along_seams(Bytes& bytes, Mesh& mesh, std::uint32_t vertices) {
    std::vector<std::uint32_t> stands_on;
    std::map<std::uint32_t, std::uint32_t> copies;
    const std::size_t first = bytes.byte(), count = bytes.byte();
    for (std::size_t t = first; t < mesh.triangles.size() && t < first + count; ++t)
        for (int i = 0; i < 3; ++i) {
            const std::uint32_t corner = mesh.triangles[t][i];
            const auto next = vertices + static_cast<std::uint32_t>(stands_on.size());
            const auto [copy, is_new] = copies.try_emplace(corner, next);
            if (is_new) stands_on.push_back(corner);
            mesh.triangles[t][i] = copy->second;
        }
    return stands_on;
}

/// The values of the old vertices, then those of the vertices that stand on them.
void stand_on(Position& position, const std::vector<std::uint32_t>& stands_on) {
    const std::size_t vertices = value_count(position) / 3;
    std::vector<std::uint32_t> all(vertices);
    for (std::uint32_t v = 0; v < vertices; ++v) all[v] = v;
    for (const std::uint32_t vertex : stands_on) all.push_back(vertex < vertices ? vertex : 0);
    position = gather(position, all);
}

Bound make_bound(Bytes& bytes) {
    switch (bytes.byte() % 4) {
    case 0: return unbounded();
    case 1: return absolute(bytes.number());
    default: return relative((1 + bytes.byte()) / 256.0);
    }
}

Box make_box(Bytes& bytes) {
    const auto corner = [&bytes] { return glm::dvec3(bytes.number(), bytes.number(), bytes.number()); };
    const glm::dvec3 p = corner(), q = corner();
    return {glm::min(p, q), glm::max(p, q)};
}

void make_locks(Bytes& bytes, const Mesh& mesh, Options& options) {
    for (int i = bytes.byte() % 3; i > 0; --i)
        options.locked.push_back(bytes.byte() % static_cast<std::uint32_t>(vertex_count(mesh)));
    if (bytes.once_in(8)) options.locked_boxes.push_back(make_box(bytes));
    if (bytes.once_in(8)) options.locked_regions.push_back(bytes.byte() % 3);
}

} // namespace

std::uint8_t Bytes::byte() {
    if (left_ == 0) return 0;
    --left_;
    return *data_++;
}

double Bytes::raw_double() {
    std::uint8_t bytes[8];
    for (std::uint8_t& b : bytes) b = byte();
    double value = 0;
    std::memcpy(&value, bytes, sizeof value);
    return value;
}

double Bytes::number() {
    const std::uint8_t kind = byte();
    const double small = signed_byte() / 8.0;
    switch (kind % 16) {
    case 0: return small * 1e30;
    case 1: return small * 1e-30;
    case 2: return small + 1e6;
    case 3: return raw_double();
    default: return small;
    }
}

Mesh make_mesh(Bytes& bytes) {
    Mesh mesh;
    const std::uint32_t columns = 2 + bytes.byte() % 6, rows = 2 + bytes.byte() % 6;
    const std::uint32_t vertices = columns * rows;
    if (bytes.byte() % 4) add_grid(bytes, mesh, columns, rows);
    for (int extra = bytes.byte() % 16; extra > 0; --extra)
        mesh.triangles.push_back({bytes.byte() % vertices, bytes.byte() % vertices, bytes.byte() % vertices});
    if (bytes.once_in(3)) add_coincident(bytes, mesh);
    std::vector<std::uint32_t> stands_on;
    if (bytes.once_in(3)) stands_on = part_along_seams(bytes, mesh, vertices);
    mesh.position = {
        (bytes.byte() % 2 ? make_variable(bytes, "", 3, vertices) : make_terrain(bytes, columns, rows)).values};
    stand_on(mesh.position, stands_on);
    const std::size_t all = vertex_count(mesh);
    for (int i = bytes.byte() % 3; i > 0; --i)
        mesh.variables.push_back(make_variable(bytes, "v" + std::to_string(i), 1 + bytes.byte() % 3, all));
    if (bytes.once_in(3)) mesh.variables.push_back(make_focus(bytes, all));
    if (bytes.once_in(3))
        for (std::size_t t = 0; t < mesh.triangles.size(); ++t) mesh.regions.push_back(bytes.byte() % 3);
    return mesh;
}

Bounds make_bounds(Bytes& bytes) { return {{"position", make_bound(bytes)}, {"*", make_bound(bytes)}}; }

Options make_options(Bytes& bytes, const Mesh& mesh) {
    Options options;
    options.threads = 1;
    const std::uint8_t bits = bytes.byte();
    options.errors = bits & 1 ? ErrorAccounting::propagated : ErrorAccounting::tracked;
    options.cost = bits & 2 ? RetriangulationCost::maximum : RetriangulationCost::introduced;
    options.optimize_vertex_images = !(bits & 4);
    options.optimize_edge_crossings = !(bits & 8);
    options.refuse_piercing = bits & 16;
    options.limit_to_feature_size = (bits & 96) == 96;
    options.drop_small_components = bits & 128;
    if (!mesh.variables.empty() && mesh.variables.back().name == "focus") options.bound_multiplier = "focus";
    make_locks(bytes, mesh, options);
    return options;
}

} // namespace fuzz
