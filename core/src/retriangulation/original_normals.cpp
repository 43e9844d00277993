#include "retriangulation/original_normals.hpp"

#include <algorithm>
#include <tuple>

#include <glm/geometric.hpp>

#include "geometry/upper_float.hpp"

namespace meshbound {
namespace {

using Corners = std::array<std::uint32_t, 3>;

/// A direction as the longest vector of whole numbers that fits.
glm::i16vec3 whole_numbers(const glm::dvec3& unit) { return glm::i16vec3(glm::floor(32767.0 * unit + 0.5)); }

/// Calls `visit` with each triangle, its corners and its area vector.
template <class Visit>
void for_each_triangle(const Surface& surface, const Rows& rows, Visit visit) {
    for (std::uint32_t slot = 0; slot < surface.slot_count(); ++slot) {
        if (!surface.alive(slot)) continue;
        const Corners corners = {surface.origin(3 * slot), surface.origin(3 * slot + 1), surface.origin(3 * slot + 2)};
        const glm::dvec3 first = rows.position(corners[0]);
        visit(slot, corners, glm::cross(rows.position(corners[1]) - first, rows.position(corners[2]) - first));
    }
}

} // namespace

OriginalNormals::OriginalNormals(const Surface& surface, const Rows& rows) {
    std::vector<glm::dvec3> vectors(surface.vertex_count(), glm::dvec3(0));
    for_each_triangle(surface, rows, [&](std::uint32_t, const Corners& corners, const glm::dvec3& vector) {
        for (const std::uint32_t corner : corners) vectors[corner] += vector;
    });
    normals_.reserve(vectors.size());
    for (const glm::dvec3& vector : vectors) {
        const double length = glm::length(vector);
        normals_.push_back(length > 0 ? whole_numbers(vector / length) : glm::i16vec3(0));
    }
    for_each_triangle(surface, rows, [&](std::uint32_t, const Corners& corners, const glm::dvec3& vector) {
        const glm::dvec3 mean = sum(corners);
        const double product = glm::dot(mean, vector);
        if (!(product < 0)) return;
        const double cosine = product / (glm::length(mean) * glm::length(vector));
        for (const std::uint32_t corner : corners) turns_.push_back({corner, -upper_float(-cosine)});
    });
    std::sort(turns_.begin(), turns_.end(),
              [](const Turn& a, const Turn& b) { return std::tie(a.vertex, a.cosine) < std::tie(b.vertex, b.cosine); });
    const auto same_vertex = [](const Turn& a, const Turn& b) { return a.vertex == b.vertex; };
    turns_.erase(std::unique(turns_.begin(), turns_.end(), same_vertex), turns_.end());
    turns_.shrink_to_fit();
}

/// 0 where none turns.
float OriginalNormals::least_cosine(std::uint32_t vertex) const {
    const auto turn = std::lower_bound(turns_.begin(), turns_.end(), vertex,
                                       [](const Turn& a, std::uint32_t b) { return a.vertex < b; });
    return turn != turns_.end() && turn->vertex == vertex ? turn->cosine : 0.0F;
}

double OriginalNormals::least_cosine(const Corners& corners) const {
    return std::min({least_cosine(corners[0]), least_cosine(corners[1]), least_cosine(corners[2])});
}

std::size_t OriginalNormals::count_turned(const Surface& surface, const Rows& rows,
                                          const std::function<std::size_t(std::uint32_t)>& sides) const {
    std::size_t count = 0;
    for_each_triangle(surface, rows, [&](std::uint32_t slot, const Corners& corners, const glm::dvec3& vector) {
        if (glm::dot(sum(corners), vector) < 0) count += sides(slot);
    });
    return count;
}

} // namespace meshbound
