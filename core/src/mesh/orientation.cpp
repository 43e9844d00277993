#include "mesh/orientation.hpp"

#include <array>
#include <cstdint>
#include <utility>

#include "mesh/half_edges_by_edge.hpp"
#include "mesh/repeats_vertex.hpp"

namespace meshbound {
namespace {

constexpr std::uint32_t no_neighbour = 0xffffffff;

struct Neighbour {
    std::uint32_t triangle = no_neighbour;
    bool inconsistent = false; // both run along the edge in the same direction
};

/// By half-edge the neighbour across it, where its edge has exactly two triangles. Degenerate triangles have none.
std::vector<Neighbour> find_neighbours(const std::vector<glm::uvec3>& triangles, std::size_t vertices,
                                       const std::vector<char>& two_sided) {
    std::vector<std::uint32_t> origin, proper; // the proper triangles among all
    origin.reserve(3 * triangles.size());
    for (std::uint32_t t = 0; t < triangles.size(); ++t) {
        const glm::uvec3& triangle = triangles[t];
        if (repeats_vertex(triangle)) continue;
        origin.insert(origin.end(), {triangle.x, triangle.y, triangle.z});
        proper.push_back(t);
    }
    std::vector<Neighbour> neighbours(3 * triangles.size());
    HalfEdgesByEdge(origin, vertices).for_each_edge([&](const std::uint32_t* run, std::size_t count) {
        if (count != 2) return;
        if (!two_sided.empty() && two_sided[proper[run[0] / 3]] != two_sided[proper[run[1] / 3]]) return;
        const bool inconsistent = origin[run[0]] == origin[run[1]];
        for (const int i : {0, 1})
            neighbours[3 * std::size_t{proper[run[i] / 3]} + run[i] % 3] = {proper[run[1 - i] / 3], inconsistent};
    });
    return neighbours;
}

/// Traverses one connected component after another, each from its first triangle.
class ComponentTraversal {
public:
    explicit ComponentTraversal(std::vector<Neighbour> neighbours)
        : neighbours_(std::move(neighbours)), sides_(neighbours_.size() / 3, unknown) {}

    /// The triangles of the component of `first`; what it returns is overwritten by the next call.
    const std::vector<std::uint32_t>& component_of(std::uint32_t first) {
        component_.assign(1, first);
        sides_[first] = 0;
        orientable_ = true;
        for (std::size_t n = 0; n < component_.size(); ++n)
            for (std::uint32_t h = 3 * component_[n]; h < 3 * component_[n] + 3; ++h)
                step(component_[n], neighbours_[h]);
        return component_;
    }

    bool seen(std::uint32_t triangle) const { return sides_[triangle] != unknown; }
    /// Whether the component traversed last has a consistent orientation.
    bool orientable() const { return orientable_; }
    /// Whether a triangle is oriented oppositely to the first one of its component.
    bool is_opposite(std::uint32_t triangle) const { return sides_[triangle] == 1; }

    /// How many edges of the component traversed last, counted twice each, are inconsistently oriented: as given, and
    /// once all opposite triangles are flipped.
    struct Inconsistency {
        std::size_t given = 0, left = 0;
    };
    Inconsistency inconsistency() const {
        Inconsistency inconsistency;
        for (const std::uint32_t triangle : component_)
            for (std::uint32_t h = 3 * triangle; h < 3 * triangle + 3; ++h) {
                const Neighbour& to = neighbours_[h];
                if (to.triangle == no_neighbour) continue;
                inconsistency.given += to.inconsistent;
                inconsistency.left += to.inconsistent != (sides_[triangle] != sides_[to.triangle]);
            }
        return inconsistency;
    }

private:
    static constexpr char unknown = 2;

    void step(std::uint32_t from, const Neighbour& to) {
        if (to.triangle == no_neighbour) return;
        const char side = to.inconsistent ? static_cast<char>(1 - sides_[from]) : sides_[from];
        if (sides_[to.triangle] == unknown) {
            sides_[to.triangle] = side;
            component_.push_back(to.triangle);
        } else if (sides_[to.triangle] != side) {
            orientable_ = false;
        }
    }

    std::vector<Neighbour> neighbours_;
    std::vector<char> sides_; // by triangle: that of the component's first one (0) or the opposite (1)
    std::vector<std::uint32_t> component_;
    bool orientable_ = true;
};

} // namespace

Orientation orient(const std::vector<glm::uvec3>& triangles, std::size_t vertices, const std::vector<char>& two_sided) {
    Orientation result{triangles};
    ComponentTraversal traversal(find_neighbours(triangles, vertices, two_sided));
    for (std::uint32_t first = 0; first < triangles.size(); ++first) {
        if (traversal.seen(first)) continue;
        const std::vector<std::uint32_t>& component = traversal.component_of(first);
        const bool counts = two_sided.empty() || !two_sided[first];
        if (!traversal.orientable()) {
            if (counts && result.unorientable_components++ == 0) result.unorientable_triangle = first;
            if (const ComponentTraversal::Inconsistency inconsistency = traversal.inconsistency();
                inconsistency.left >= inconsistency.given)
                continue;
        }
        std::size_t opposite = 0;
        for (const std::uint32_t triangle : component) opposite += traversal.is_opposite(triangle);
        const bool flip_opposite = 2 * opposite <= component.size();
        for (const std::uint32_t triangle : component) {
            if (traversal.is_opposite(triangle) != flip_opposite) continue;
            std::swap(result.triangles[triangle].y, result.triangles[triangle].z);
            result.flipped += counts;
        }
    }
    return result;
}

void note_orientation(const Orientation& orientation, MeshDefects& defects) {
    defects.flipped_triangles = orientation.flipped;
    defects.unorientable_components = orientation.unorientable_components;
    if (orientation.unorientable_components > 0) defects.unorientable_triangle = orientation.unorientable_triangle;
}

} // namespace meshbound
