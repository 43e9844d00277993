#include "meshes/variations.hpp"

#include <algorithm>
#include <map>
#include <numeric>
#include <utility>
#include <variant>

#include <glm/geometric.hpp>

#include "meshes/random.hpp"
#include "meshes/shapes.hpp"

namespace meshes {
namespace {

using Edge = std::pair<std::uint32_t, std::uint32_t>;

/// A triangle and which of its corners lies across the edge.
struct Side {
    std::size_t triangle;
    int corner;
};

/// For each directed edge the triangle on its left.
std::map<Edge, Side> sides_of(const std::vector<glm::uvec3>& triangles) {
    std::map<Edge, Side> sides;
    for (std::size_t t = 0; t < triangles.size(); ++t)
        for (int i = 0; i < 3; ++i) sides[{triangles[t][(i + 1) % 3], triangles[t][(i + 2) % 3]}] = {t, i};
    return sides;
}

glm::dvec3 normal(const Mesh& mesh, std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    return glm::cross(point(mesh, b) - point(mesh, a), point(mesh, c) - point(mesh, a));
}

/// Whether the edge b-c of the triangles a, b, c and d, c, b may become a-d.
bool may_flip(const Mesh& mesh, std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
    const glm::dvec3 before = normal(mesh, a, b, c) + normal(mesh, d, c, b);
    return glm::dot(before, normal(mesh, a, b, d)) > 0 && glm::dot(before, normal(mesh, a, d, c)) > 0;
}

/// The variable with its vertices in a new order: vertex i becomes new_index[i].
template <class Kind>
Kind reordered(const Kind& variable, const std::vector<std::uint32_t>& new_index) {
    std::vector<std::uint32_t> old_index(new_index.size());
    for (std::uint32_t v = 0; v < new_index.size(); ++v) old_index[new_index[v]] = v;
    return gather(variable, old_index);
}

std::vector<std::uint32_t> permutation(std::size_t count, Random& random) {
    std::vector<std::uint32_t> order(count);
    std::iota(order.begin(), order.end(), 0U);
    for (std::size_t i = count; i > 1; --i) std::swap(order[i - 1], order[random.below(i)]);
    return order;
}

std::vector<float> rounded(const meshbound::Values& numbers) {
    std::vector<float> values;
    std::visit([&](const auto& from) { values.assign(from.begin(), from.end()); }, numbers);
    return values;
}

} // namespace

Mesh in_single(const Mesh& mesh) {
    Mesh single = mesh;
    single.position.values = rounded(mesh.position.values);
    for (meshbound::Variable& variable : single.variables) variable.values = rounded(variable.values);
    return single;
}

Mesh mapped(const Mesh& mesh, const std::function<glm::dvec3(glm::dvec3)>& map) {
    Mesh result = mesh;
    std::visit(
        [&](auto& values) {
            using Value = typename std::decay_t<decltype(values)>::value_type;
            for (std::size_t v = 0; v < vertex_count(mesh); ++v) {
                const glm::dvec3 p = map(point(mesh, v));
                for (int k = 0; k < 3; ++k) values[3 * v + k] = static_cast<Value>(p[k]);
            }
        },
        result.position.values);
    return result;
}

void map_values(meshbound::Values& numbers, const std::function<double(double)>& map) {
    std::visit(
        [&](auto& values) {
            for (auto& value : values) value = static_cast<std::decay_t<decltype(value)>>(map(value));
        },
        numbers);
}

Mesh reversed(const Mesh& mesh) {
    Mesh result = mesh;
    for (glm::uvec3& t : result.triangles) std::swap(t.y, t.z);
    return result;
}

Mesh shuffled(const Mesh& mesh, std::uint64_t seed) {
    Random random(seed);
    const auto vertex_order = permutation(vertex_count(mesh), random);
    const auto triangle_order = permutation(mesh.triangles.size(), random);
    Mesh result{reordered(mesh.position, vertex_order), mesh.triangles, {}, {}};
    for (const auto& variable : mesh.variables) result.variables.push_back(reordered(variable, vertex_order));
    for (std::size_t i = 0; i < triangle_order.size(); ++i) {
        const glm::uvec3 t = mesh.triangles[triangle_order[i]];
        const int first = static_cast<int>(random.below(3));
        for (int k = 0; k < 3; ++k) result.triangles[i][k] = vertex_order[t[(first + k) % 3]];
    }
    return result;
}

Mesh flipped(const Mesh& mesh, std::size_t flips, std::uint64_t seed) {
    Random random(seed);
    Mesh result = mesh;
    auto sides = sides_of(mesh.triangles);
    for (std::size_t i = 0; i < flips; ++i) {
        const std::size_t t = random.below(result.triangles.size());
        const int corner = static_cast<int>(random.below(3));
        const glm::uvec3 triangle = result.triangles[t];
        const std::uint32_t a = triangle[corner], b = triangle[(corner + 1) % 3], c = triangle[(corner + 2) % 3];
        const auto across = sides.find({c, b});
        if (across == sides.end()) continue;
        const auto [other, other_corner] = across->second;
        const std::uint32_t d = result.triangles[other][other_corner];
        if (sides.count({a, d}) || sides.count({d, a}) || !may_flip(result, a, b, c, d)) continue;
        sides.erase({b, c});
        sides.erase({c, b});
        result.triangles[t] = {a, b, d};
        result.triangles[other] = {a, d, c};
        for (const std::size_t changed : {t, other})
            for (int k = 0; k < 3; ++k) {
                const glm::uvec3& now = result.triangles[changed];
                sides[{now[(k + 1) % 3], now[(k + 2) % 3]}] = {changed, k};
            }
    }
    return result;
}

Mesh jittered(const Mesh& mesh, double size, std::uint64_t seed) {
    Random random(seed);
    std::vector<bool> stays(vertex_count(mesh), false);
    const auto sides = sides_of(mesh.triangles);
    for (const auto& [edge, side] : sides)
        if (!sides.count({edge.second, edge.first})) stays[edge.first] = stays[edge.second] = true;
    std::size_t vertex = 0;
    return mapped(mesh, [&](glm::dvec3 p) {
        if (stays[vertex++]) return p;
        // One after the other: compilers evaluate the arguments of a call in orders of their own.
        const double z = random.uniform(-size, size), y = random.uniform(-size, size), x = random.uniform(-size, size);
        return p + glm::dvec3(x, y, z);
    });
}

Mesh joined(const Mesh& one, const Mesh& other) {
    const auto append = [](meshbound::Values& to, const meshbound::Values& from) {
        std::visit(
            [&](auto& values) {
                const auto& more = std::get<std::decay_t<decltype(values)>>(from);
                values.insert(values.end(), more.begin(), more.end());
            },
            to);
    };
    Mesh result = one;
    append(result.position.values, other.position.values);
    for (std::size_t i = 0; i < one.variables.size(); ++i)
        append(result.variables[i].values, other.variables[i].values);
    const auto shift = static_cast<std::uint32_t>(vertex_count(one));
    for (const glm::uvec3& t : other.triangles) result.triangles.push_back(t + shift);
    return result;
}

Mesh cut(const Mesh& mesh, const std::function<bool(glm::dvec3)>& keep) {
    Mesh result = mesh;
    result.triangles.clear();
    for (const glm::uvec3& t : mesh.triangles)
        if (keep((point(mesh, t.x) + point(mesh, t.y) + point(mesh, t.z)) / 3.0)) result.triangles.push_back(t);
    return result;
}

} // namespace meshes
