#include "meshes/sheet.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <vector>

#include <glm/common.hpp>

namespace meshes {
namespace {

using namespace meshbound;
using Corners = std::array<std::uint32_t, 3>;

Corners sorted(const glm::uvec3& t) {
    Corners corners = {t.x, t.y, t.z};
    std::sort(corners.begin(), corners.end());
    return corners;
}

/// The corners from the lowest on: two triangles have the same ones if they face the same way.
Corners in_order(const glm::uvec3& t) {
    Corners corners = {t.x, t.y, t.z};
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    return corners;
}

/// Keeps the first triangle of each key; by triangle the number of the one that is kept for it.
std::vector<std::uint32_t> keep_first(Mesh& mesh, Corners (*key)(const glm::uvec3&)) {
    std::vector<std::uint32_t> kept_as;
    std::map<Corners, std::uint32_t> met;
    Mesh kept;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const auto next = static_cast<std::uint32_t>(kept.triangles.size());
        const auto [first, is_new] = met.try_emplace(key(mesh.triangles[t]), next);
        kept_as.push_back(first->second);
        if (!is_new) continue;
        kept.triangles.push_back(mesh.triangles[t]);
        if (!mesh.regions.empty()) kept.regions.push_back(mesh.regions[t]);
    }
    mesh.triangles = kept.triangles;
    mesh.regions = kept.regions;
    return kept_as;
}

/// A place in a triangle is one in another on the same vertices, with its weights in that one's order.
glm::dvec3 weights_in(const glm::uvec3& to, const glm::uvec3& from, const glm::dvec3& weights) {
    glm::dvec3 turned(0);
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            if (from[i] == to[j]) turned[j] = weights[i];
    return turned;
}

} // namespace

Mesh one_sided(Mesh mesh) {
    keep_first(mesh, sorted);
    mesh.regions.clear();
    return mesh;
}

Reduction one_sided(Reduction reduction) {
    const std::vector<glm::uvec3> all = reduction.mesh.triangles;
    const std::vector<std::uint32_t> kept_as = keep_first(reduction.mesh, sorted);
    reduction.mesh.regions.clear();
    for (SurfacePoint& place : reduction.map.images) {
        if (place.triangle == nowhere) continue;
        const std::uint32_t kept = kept_as[place.triangle];
        place.barycentric = weights_in(reduction.mesh.triangles[kept], all[place.triangle], place.barycentric);
        place.triangle = kept;
    }
    return reduction;
}

Mesh without_copies(Mesh mesh) {
    keep_first(mesh, in_order);
    return mesh;
}

} // namespace meshes
