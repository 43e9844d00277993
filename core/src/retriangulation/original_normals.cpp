#include "retriangulation/original_normals.hpp"

#include <algorithm>
#include <tuple>

#include <glm/geometric.hpp>

#include "geometry/round_up_to_float.hpp"

namespace meshbound {
namespace {

using Corners = std::array<std::uint32_t, 3>;

/// A unit vector, quantized.
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
        for (const std::uint32_t corner : corners) deviations_.push_back({corner, -round_up_to_float(-cosine)});
    });
    std::sort(deviations_.begin(), deviations_.end(), [](const Deviation& a, const Deviation& b) {
        return std::tie(a.vertex, a.cosine) < std::tie(b.vertex, b.cosine);
    });
    const auto same_vertex = [](const Deviation& a, const Deviation& b) { return a.vertex == b.vertex; };
    deviations_.erase(std::unique(deviations_.begin(), deviations_.end(), same_vertex), deviations_.end());
    deviations_.shrink_to_fit();
}

/// 0 where none deviates by more than a right angle.
float OriginalNormals::least_cosine(std::uint32_t vertex) const {
    const auto deviation = std::lower_bound(deviations_.begin(), deviations_.end(), vertex,
                                            [](const Deviation& a, std::uint32_t b) { return a.vertex < b; });
    return deviation != deviations_.end() && deviation->vertex == vertex ? deviation->cosine : 0.0F;
}

double OriginalNormals::least_cosine(const Corners& corners) const {
    return std::min({least_cosine(corners[0]), least_cosine(corners[1]), least_cosine(corners[2])});
}

std::size_t OriginalNormals::count_flipped_normals(const Surface& surface, const Rows& rows,
                                                   const std::function<std::size_t(std::uint32_t)>& sides) const {
    std::size_t count = 0;
    for_each_triangle(surface, rows, [&](std::uint32_t slot, const Corners& corners, const glm::dvec3& vector) {
        if (glm::dot(sum(corners), vector) < 0) count += sides(slot);
    });
    return count;
}

} // namespace meshbound
