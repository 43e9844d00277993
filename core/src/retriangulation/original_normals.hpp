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

/// Where the original faces, at its vertices and between them. A reduced triangle stands for the original between three of
/// its vertices. It turns more than a right angle against it where its own normal does so against the mean of the original's
/// normals at these, each of which is the area-weighted mean of those of the triangles there.
class OriginalNormals {
public:
    /// The surface is the original still.
    OriginalNormals(const Surface& surface, const Rows& rows);

    /// Where the original faces at a vertex; all of one length, but for rounding, or zero where it faces nowhere.
    glm::dvec3 direction(std::uint32_t vertex) const { return glm::dvec3(normals_[vertex]); }

    /// The least cosine by which a triangle of the original turns at one of these vertices; 0 where none turns more than a
    /// right angle.
    double least_cosine(const std::array<std::uint32_t, 3>& corners) const;

    /// How many triangles of a surface over the same vertices turn more than a right angle; each counts `sides(triangle)` times.
    std::size_t count_turned(const Surface& surface, const Rows& rows,
                             const std::function<std::size_t(std::uint32_t)>& sides) const;

private:
    glm::dvec3 sum(const std::array<std::uint32_t, 3>& corners) const {
        return direction(corners[0]) + direction(corners[1]) + direction(corners[2]);
    }

    /// The least cosine by which an original triangle turns at a vertex.
    struct Turn {
        std::uint32_t vertex;
        float cosine; // negative, rounded down
    };
    float least_cosine(std::uint32_t vertex) const;

    // In whole numbers, which are enough for a direction.
    std::vector<glm::i16vec3> normals_; // by vertex, all of one length; zero where the original faces nowhere
    std::vector<Turn> turns_;           // by rising vertices, the few at which one turns
};

} // namespace meshbound
