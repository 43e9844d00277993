#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include <glm/vec3.hpp>

#include "meshbound/api.hpp"
#include "meshbound/glm_layout.hpp"

namespace meshbound {

/// Numbers in the precision they came in. Whatever comes in single precision goes out in single precision, bit for bit.
using Values = std::variant<std::vector<float>, std::vector<double>>;

/// A named array at the vertices, linear on every triangle.
///
/// `values` is interleaved: component j of vertex i stands at `values[i * components + j]`. A vector (velocity) is ONE
/// variable with three components; its error is the Euclidean norm of the difference.
///
///     Variable temperature{"temperature", 1, std::vector<float>{300, 310, 305}};            // three vertices
///     Variable velocity{"velocity", 3, std::vector<double>{1, 0, 0, 1, 0, 0, 0.9, 0.1, 0}}; // the same three
struct Variable {
    std::string name;
    int components = 1;
    Values values;
};

/// An oriented triangle mesh that carries data. The geometry is the variable `position`, so that position and data share
/// one code path; its name is always "position".
///
///     Mesh mesh;                                                            // a unit square of two triangles
///     mesh.position.values = std::vector<float>{0,0,0, 1,0,0, 1,1,0, 0,1,0}; // in the user's unit of length
///     mesh.triangles = {{0, 1, 2}, {0, 2, 3}};                              // counter-clockwise seen from outside
///     mesh.variables = {{"height", 1, std::vector<float>{0, 1, 2, 3}}};
struct Mesh {
    Variable position{"position", 3, std::vector<float>{}};
    std::vector<glm::uvec3> triangles;
    std::vector<Variable> variables;
    /// A label for each triangle, or none at all. Where labels differ the surface has a border, which is kept within the
    /// bounds: each side keeps its label, and so do the corners in which borders meet or end.
    std::vector<std::int32_t> regions;
};

/// How many numbers a variable holds, over all vertices and components.
MESHBOUND_API std::size_t value_count(const Variable& variable);

/// How many vertices a mesh has, used or not: a third of the number of its coordinates.
MESHBOUND_API std::size_t vertex_count(const Mesh& mesh);

/// Component `component` of vertex `vertex`, widened to double (exact).
MESHBOUND_API double value_at(const Variable& variable, std::size_t vertex, int component);

/// The same variable at the given vertices only, in their order, in the same precision, bit for bit.
MESHBOUND_API Variable gather(const Variable& variable, const std::vector<std::uint32_t>& vertices);

} // namespace meshbound
