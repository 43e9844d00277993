#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include <glm/gtc/type_precision.hpp>
#include <glm/vec3.hpp>

#include "metric/rows.hpp"
#include "surface/surface.hpp"

namespace meshbound {

/// The original's vertex normals, area-weighted. A reduced triangle stands for the original between three of its
/// vertices; the deviation of its normal is the angle to the mean of the original's normals at these. Beyond a right
/// angle the normal counts as flipped.
class OriginalNormals {
public:
    /// To be made before anything is removed.
    OriginalNormals(const Surface& surface, const Rows& rows);

    /// The normal at a vertex; all of one length, but for rounding, or zero where the triangles there have none.
    glm::dvec3 normal(std::uint32_t vertex) const { return glm::dvec3(normals_[vertex]); }

    /// The least cosine of the deviations of the original triangles at these vertices; 0 where none is beyond a right
    /// angle.
    double least_cosine(const std::array<std::uint32_t, 3>& corners) const;

    /// How many triangles of a surface over the same vertices have a flipped normal; each counts `sides(triangle)`
    /// times.
    std::size_t count_flipped_normals(const Surface& surface, const Rows& rows,
                                      const std::function<std::size_t(std::uint32_t)>& sides) const;

private:
    glm::dvec3 sum(const std::array<std::uint32_t, 3>& corners) const {
        return normal(corners[0]) + normal(corners[1]) + normal(corners[2]);
    }

    /// The least cosine of the deviations at a vertex.
    struct Deviation {
        std::uint32_t vertex;
        float cosine; // negative, rounded down
    };
    float least_cosine(std::uint32_t vertex) const;

    // Quantized, which is precise enough for a direction.
    std::vector<glm::i16vec3> normals_; // by vertex, all of one length, or zero
    std::vector<Deviation> deviations_; // in the order of vertices: the few with a deviation beyond a right angle
};

} // namespace meshbound
