#include "locks.hpp"

#include <algorithm>

#include <glm/common.hpp>

namespace meshbound {
namespace {

Box box_of(const Mesh& mesh, const glm::uvec3& triangle) {
    const auto point = [&](int corner) {
        const auto axis = [&](int i) { return value_at(mesh.position, triangle[corner], i); };
        return glm::dvec3(axis(0), axis(1), axis(2));
    };
    const glm::dvec3 a = point(0), b = point(1), c = point(2);
    return {glm::min(a, glm::min(b, c)), glm::max(a, glm::max(b, c))};
}

bool meet(const Box& one, const Box& other) {
    for (int axis = 0; axis < 3; ++axis)
        if (one.highest[axis] < other.lowest[axis] || other.highest[axis] < one.lowest[axis]) return false;
    return true;
}

} // namespace

std::vector<std::uint32_t> locked_vertices(const Mesh& mesh, const Options& options) {
    std::vector<std::uint32_t> locked = options.locked;
    if (options.locked_boxes.empty()) return locked;
    for (const glm::uvec3& triangle : mesh.triangles) {
        const Box box = box_of(mesh, triangle);
        if (std::any_of(options.locked_boxes.begin(), options.locked_boxes.end(),
                        [&box](const Box& of_user) { return meet(box, of_user); }))
            locked.insert(locked.end(), {triangle.x, triangle.y, triangle.z});
    }
    return locked;
}

} // namespace meshbound
