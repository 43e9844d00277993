#include "reduction/locks.hpp"

#include <algorithm>
#include <numeric>

#include <glm/common.hpp>

#include "mesh/position_at.hpp"
#include "mesh/repeats_vertex.hpp"

namespace meshbound {
namespace {

Box box_of(const Mesh& mesh, const glm::uvec3& triangle) {
    const glm::dvec3 a = position_at(mesh, triangle.x), b = position_at(mesh, triangle.y),
                     c = position_at(mesh, triangle.z);
    return {glm::min(a, glm::min(b, c)), glm::max(a, glm::max(b, c))};
}

bool meet(const Box& one, const Box& other) {
    for (int axis = 0; axis < 3; ++axis)
        if (one.highest[axis] < other.lowest[axis] || other.highest[axis] < one.lowest[axis]) return false;
    return true;
}

bool meets_locked_box(const Mesh& mesh, const Options& options, const glm::uvec3& triangle) {
    if (options.locked_boxes.empty()) return false;
    const Box box = box_of(mesh, triangle);
    return std::any_of(options.locked_boxes.begin(), options.locked_boxes.end(),
                       [&box](const Box& of_user) { return meet(box, of_user); });
}

bool is_in_locked_region(const Mesh& mesh, const Options& options, std::size_t triangle) {
    const std::vector<std::int32_t>& locked = options.locked_regions;
    return !mesh.regions.empty() && std::find(locked.begin(), locked.end(), mesh.regions[triangle]) != locked.end();
}

} // namespace

/// A triangle with a vertex twice is no part of the surface: nothing stays because of it.
std::vector<std::uint32_t> locked_vertices(const Mesh& mesh, const Options& options) {
    std::vector<std::uint32_t> locked = options.locked;
    if (options.locked_boxes.empty() && options.locked_regions.empty()) return locked;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const glm::uvec3& triangle = mesh.triangles[t];
        if (repeats_vertex(triangle)) continue;
        if (is_in_locked_region(mesh, options, t) || meets_locked_box(mesh, options, triangle))
            locked.insert(locked.end(), {triangle.x, triangle.y, triangle.z});
    }
    return locked;
}

std::vector<std::size_t> unused_locked_boxes(const Mesh& mesh, const Options& options) {
    std::vector<std::size_t> unmet(options.locked_boxes.size());
    std::iota(unmet.begin(), unmet.end(), std::size_t{0});
    for (std::size_t t = 0; t < mesh.triangles.size() && !unmet.empty(); ++t) {
        if (repeats_vertex(mesh.triangles[t])) continue;
        const Box box = box_of(mesh, mesh.triangles[t]);
        std::erase_if(unmet, [&](std::size_t i) { return meet(box, options.locked_boxes[i]); });
    }
    return unmet;
}

} // namespace meshbound
