#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include <glm/vec3.hpp>

#include "meshbound/api.hpp"
#include "meshbound/glm_layout.hpp"

namespace meshbound {

/// Numbers in the precision they came in. Whatever comes in single precision goes out in single precision, bit for bit.
using Values = std::variant<std::vector<float>, std::vector<double>>;

/// What the numbers of a variable are.
enum class VariableKind {
    quantity,   ///< they vary over the surface, and between two of them lie others that mean something
    identifier, ///< they name things (numbers of points, masks); no bound for all variables ("*") is about them
};

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
    VariableKind kind = VariableKind::quantity;
};

/// What the geometry is called wherever variables have names. No variable of a mesh may be called so.
inline constexpr std::string_view position_name = "position";

/// Where the vertices are: three coordinates each, x0 y0 z0 x1 y1 z1 …, in the user's unit of length.
struct Position {
    Values values = std::vector<float>{};
};

/// An oriented triangle mesh that carries data. Its geometry is a variable like those (see variable_of), so that position and
/// data share one code path; that one is called "position", and nothing else is.
///
///     Mesh mesh;                                                            // a unit square of two triangles
///     mesh.position.values = std::vector<float>{0,0,0, 1,0,0, 1,1,0, 0,1,0}; // in the user's unit of length
///     mesh.triangles = {{0, 1, 2}, {0, 2, 3}};                              // counter-clockwise seen from outside
///     mesh.variables = {{"height", 1, std::vector<float>{0, 1, 2, 3}}};
///
/// Vertices that no triangle of three distinct vertices uses are no part of the surface: whatever stands there counts for
/// nothing, and they are left out of every result.
struct Mesh {
    Position position;
    std::vector<glm::uvec3> triangles;
    std::vector<Variable> variables;
    /// A label for each triangle, or none at all. Where labels differ the surface has a border, which is kept within the
    /// bounds: each side keeps its label, and so do the corners in which borders meet or end.
    std::vector<std::int32_t> regions;
};

/// A variable of a mesh, the geometry or another one, to be read while the mesh stays as it is.
struct VariableView {
    std::string_view name;
    int components;
    const Values& values;
    VariableKind kind;

    VariableView(const Variable& variable)
        : name(variable.name), components(variable.components), values(variable.values), kind(variable.kind) {}
    VariableView(const Position& position)
        : name(position_name), components(3), values(position.values), kind(VariableKind::quantity) {}
};

/// How many variables a mesh has, position among them.
inline std::size_t variable_count(const Mesh& mesh) { return 1 + mesh.variables.size(); }

/// Variable `number` of a mesh: position first, then the mesh's variables in their order.
inline VariableView variable_of(const Mesh& mesh, std::size_t number) {
    return number == 0 ? VariableView(mesh.position) : VariableView(mesh.variables[number - 1]);
}

/// How many numbers a variable holds, over all vertices and components.
MESHBOUND_API std::size_t value_count(const VariableView& variable);

/// How many vertices a mesh has, used or not: a third of the number of its coordinates.
MESHBOUND_API std::size_t vertex_count(const Mesh& mesh);

/// Component `component` of vertex `vertex`, widened to double (exact).
MESHBOUND_API double value_at(const VariableView& variable, std::size_t vertex, int component);

/// The same variable at the given vertices only, in their order, in the same precision, bit for bit.
MESHBOUND_API Variable gather(const Variable& variable, const std::vector<std::uint32_t>& vertices);

/// The same of the geometry.
MESHBOUND_API Position gather(const Position& position, const std::vector<std::uint32_t>& vertices);

} // namespace meshbound
