#include "surface/small_parts.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <numeric>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "mesh/used_vertices.hpp"

namespace meshbound {
namespace {

glm::dvec3 place_of(const Mesh& mesh, std::uint32_t vertex) {
    return {value_at(mesh.position, vertex, 0), value_at(mesh.position, vertex, 1), value_at(mesh.position, vertex, 2)};
}

/// Vertices in sets that grow together.
class Sets {
public:
    explicit Sets(std::size_t vertices) : parent_(vertices) { std::iota(parent_.begin(), parent_.end(), 0U); }

    std::uint32_t of(std::uint32_t vertex) {
        while (parent_[vertex] != vertex) vertex = parent_[vertex] = parent_[parent_[vertex]];
        return vertex;
    }
    /// The smallest vertex names the set.
    void join(std::uint32_t one, std::uint32_t other) {
        const std::uint32_t a = of(one), b = of(other);
        parent_[std::max(a, b)] = std::min(a, b);
    }

private:
    std::vector<std::uint32_t> parent_;
};

Sets find_parts(const Mesh& mesh, const Surface& surface) {
    Sets parts(surface.input_count());
    const auto corner = [&](std::uint32_t h) { return surface.input(surface.origin(h)); };
    for (std::uint32_t slot = 0; slot < surface.slot_count(); ++slot) {
        parts.join(corner(3 * slot), corner(3 * slot + 1));
        parts.join(corner(3 * slot), corner(3 * slot + 2));
    }
    const std::vector<char> used = find_used_vertices(mesh);
    std::vector<std::uint32_t> by_place;
    for (std::uint32_t vertex = 0; vertex < used.size(); ++vertex)
        if (used[vertex]) by_place.push_back(vertex);
    const auto place = [&](std::uint32_t vertex) {
        const glm::dvec3 p = place_of(mesh, vertex);
        return std::array{p.x, p.y, p.z};
    };
    std::sort(by_place.begin(), by_place.end(), [&](std::uint32_t a, std::uint32_t b) { return place(a) < place(b); });
    for (std::size_t i = 0; i + 1 < by_place.size(); ++i)
        if (place(by_place[i]) == place(by_place[i + 1])) parts.join(by_place[i], by_place[i + 1]);
    return parts;
}

struct Part {
    glm::dvec3 lowest{std::numeric_limits<double>::infinity()}, highest{-std::numeric_limits<double>::infinity()};
    double multiplier = std::numeric_limits<double>::infinity();
    bool kept = false;

    /// -1 where it has no vertex.
    double size() const { return lowest.x <= highest.x ? glm::distance(lowest, highest) : -1; }
};

/// By the vertex of the input that names the part.
std::vector<Part> measure_parts(const Mesh& mesh, const Multipliers& multipliers, const Surface& surface, Sets& sets) {
    std::vector<Part> parts(surface.input_count());
    for (std::uint32_t vertex = 0; vertex < surface.vertex_count(); ++vertex) {
        if (surface.kind(vertex) == VertexKind::absent) continue;
        const std::uint32_t input = surface.input(vertex);
        Part& part = parts[sets.of(input)];
        part.lowest = glm::min(part.lowest, place_of(mesh, input));
        part.highest = glm::max(part.highest, place_of(mesh, input));
        part.multiplier = std::min(part.multiplier, multipliers.at(input));
    }
    return parts;
}

} // namespace

DroppedParts drop_small_parts(const Mesh& mesh, double bound, const Multipliers& multipliers,
                              const std::vector<std::uint32_t>& kept, Surface& surface) {
    DroppedParts dropped;
    Sets sets = find_parts(mesh, surface);
    std::vector<Part> parts = measure_parts(mesh, multipliers, surface, sets);
    for (const std::uint32_t vertex : kept) parts[sets.of(vertex)].kept = true;
    std::max_element(parts.begin(), parts.end(), [](const Part& a, const Part& b) {
        return a.size() < b.size();
    })->kept = true;
    std::vector<char> vertices(surface.vertex_count(), 0);
    std::vector<char> counted(parts.size(), 0);
    for (std::uint32_t vertex = 0; vertex < vertices.size(); ++vertex) {
        const std::uint32_t name = sets.of(surface.input(vertex));
        const Part& part = parts[name];
        if (surface.kind(vertex) == VertexKind::absent || part.kept || part.size() > bound * part.multiplier) continue;
        vertices[vertex] = 1;
        dropped.parts += !counted[name];
        counted[name] = 1;
    }
    dropped.triangles = surface.drop(vertices);
    return dropped;
}

} // namespace meshbound
