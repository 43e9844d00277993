#include "surface/small_components.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <numeric>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "mesh/position_at.hpp"
#include "mesh/used_vertices.hpp"

namespace meshbound {
namespace {

/// Disjoint sets of vertices (union-find).
class DisjointSets {
public:
    explicit DisjointSets(std::size_t vertices) : parent_(vertices) { std::iota(parent_.begin(), parent_.end(), 0U); }

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

DisjointSets find_components(const Mesh& mesh, const Surface& surface) {
    DisjointSets components(surface.input_count());
    const auto corner = [&](std::uint32_t h) { return surface.input(surface.origin(h)); };
    for (std::uint32_t slot = 0; slot < surface.slot_count(); ++slot) {
        components.join(corner(3 * slot), corner(3 * slot + 1));
        components.join(corner(3 * slot), corner(3 * slot + 2));
    }
    const std::vector<char> used = find_used_vertices(mesh);
    std::vector<std::uint32_t> by_position;
    for (std::uint32_t vertex = 0; vertex < used.size(); ++vertex)
        if (used[vertex]) by_position.push_back(vertex);
    const auto position = [&](std::uint32_t vertex) {
        const glm::dvec3 p = position_at(mesh, vertex);
        return std::array{p.x, p.y, p.z};
    };
    std::sort(by_position.begin(), by_position.end(),
              [&](std::uint32_t a, std::uint32_t b) { return position(a) < position(b); });
    for (std::size_t i = 0; i + 1 < by_position.size(); ++i)
        if (position(by_position[i]) == position(by_position[i + 1]))
            components.join(by_position[i], by_position[i + 1]);
    return components;
}

struct Component {
    glm::dvec3 lowest{std::numeric_limits<double>::infinity()}, highest{-std::numeric_limits<double>::infinity()};
    double multiplier = std::numeric_limits<double>::infinity();
    bool kept = false;

    /// -1 where it has no vertex.
    double size() const { return lowest.x <= highest.x ? glm::distance(lowest, highest) : -1; }
};

/// By the input vertex that represents the component.
std::vector<Component> measure_components(const Mesh& mesh, const Multipliers& multipliers, const Surface& surface,
                                          DisjointSets& sets) {
    std::vector<Component> components(surface.input_count());
    for (std::uint32_t vertex = 0; vertex < surface.vertex_count(); ++vertex) {
        if (surface.kind(vertex) == VertexKind::absent) continue;
        const std::uint32_t input = surface.input(vertex);
        Component& component = components[sets.of(input)];
        component.lowest = glm::min(component.lowest, position_at(mesh, input));
        component.highest = glm::max(component.highest, position_at(mesh, input));
        component.multiplier = std::min(component.multiplier, multipliers.at(input));
    }
    return components;
}

} // namespace

DroppedComponents drop_small_components(const Mesh& mesh, double bound, const Multipliers& multipliers,
                                        const std::vector<std::uint32_t>& kept, Surface& surface) {
    DroppedComponents dropped;
    DisjointSets sets = find_components(mesh, surface);
    std::vector<Component> components = measure_components(mesh, multipliers, surface, sets);
    for (const std::uint32_t vertex : kept) components[sets.of(vertex)].kept = true;
    std::max_element(components.begin(), components.end(), [](const Component& a, const Component& b) {
        return a.size() < b.size();
    })->kept = true;
    std::vector<char> vertices(surface.vertex_count(), 0);
    std::vector<char> counted(components.size(), 0);
    for (std::uint32_t vertex = 0; vertex < vertices.size(); ++vertex) {
        const std::uint32_t name = sets.of(surface.input(vertex));
        const Component& component = components[name];
        if (surface.kind(vertex) == VertexKind::absent || component.kept ||
            component.size() > bound * component.multiplier)
            continue;
        vertices[vertex] = 1;
        dropped.components += !counted[name];
        counted[name] = 1;
    }
    dropped.triangles = surface.remove_marked(vertices);
    return dropped;
}

} // namespace meshbound
