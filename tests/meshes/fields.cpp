#include "meshes/fields.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>
#include <utility>
#include <vector>

#include "meshes/random.hpp"
#include "meshes/shapes.hpp"

namespace meshes {

void add_scalar(Mesh& mesh, const std::string& name, const std::function<double(glm::dvec3)>& field) {
    std::vector<double> values;
    for (std::size_t v = 0; v < vertex_count(mesh); ++v) values.push_back(field(point(mesh, v)));
    mesh.variables.push_back({name, 1, std::move(values)});
}

void add_vector(Mesh& mesh, const std::string& name, const std::function<glm::dvec3(glm::dvec3)>& field) {
    std::vector<double> values;
    for (std::size_t v = 0; v < vertex_count(mesh); ++v) {
        const glm::dvec3 value = field(point(mesh, v));
        values.insert(values.end(), {value.x, value.y, value.z});
    }
    mesh.variables.push_back({name, 3, std::move(values)});
}

double linear_field(glm::dvec3 p) { return 2 * p.x - 3 * p.y + 0.5 * p.z + 1; }

double wave_field(glm::dvec3 p) { return std::sin(2 * std::numbers::pi * (0.6 * p.x + 0.64 * p.y + 0.48 * p.z)); }

std::function<double(glm::dvec3)> jump_field(double edge) {
    return [edge](glm::dvec3 p) { return p.x < edge ? 0.0 : 1.0; };
}

glm::dvec3 whirl_field(glm::dvec3 p) { return {-p.y, p.x, 0.5 + p.x * p.x - p.z}; }

std::function<double(glm::dvec3)> constant_field(double value, double noise, std::uint64_t seed) {
    return [=, random = Random(seed)](glm::dvec3) mutable { return value * (1 + noise * random.uniform(-1, 1)); };
}

void add_usual_fields(Mesh& mesh) {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (std::size_t v = 0; v < vertex_count(mesh); ++v) {
        low = std::min(low, point(mesh, v).x);
        high = std::max(high, point(mesh, v).x);
    }
    add_scalar(mesh, "linear", linear_field);
    add_scalar(mesh, "wave", wave_field);
    add_scalar(mesh, "jump", jump_field(low + 0.53 * (high - low)));
    add_vector(mesh, "whirl", whirl_field);
}

} // namespace meshes
