#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include <glm/vec3.hpp>

#include "meshbound/mesh.hpp"

/// Variables to put on a surface, in double precision.
namespace meshes {

using meshbound::Mesh;

/// Adds a variable of one component, a function of position.
void add_scalar(Mesh& mesh, const std::string& name, const std::function<double(glm::dvec3)>& field);
/// Adds a variable of three components.
void add_vector(Mesh& mesh, const std::string& name, const std::function<glm::dvec3(glm::dvec3)>& field);

/// 2x - 3y + z/2 + 1.
double linear_field(glm::dvec3 p);
/// A wave of wavelength 1 across space.
double wave_field(glm::dvec3 p);
/// 0 on one side of the plane x = edge, 1 on the other.
std::function<double(glm::dvec3)> jump_field(double edge);
/// A whirl about the z axis that rises.
glm::dvec3 whirl_field(glm::dvec3 p);
/// `value`, up to rounding noise of the relative size `noise`.
std::function<double(glm::dvec3)> constant_field(double value, double noise, std::uint64_t seed);

/// Adds "linear", "wave", "jump" (at the middle of x) and "whirl".
void add_usual_fields(Mesh& mesh);

} // namespace meshes
