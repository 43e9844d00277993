// Writes the generated surfaces of the comparison as binary PLY files in single precision: peers_surfaces FOLDER

#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <stdexcept>
#include <string>

#include <glm/geometric.hpp>

#include "meshes/fields.hpp"
#include "meshes/shapes.hpp"
#include "meshes/variations.hpp"
#include "meshes/voxel_surface.hpp"

namespace {

using meshbound::Mesh;

/// A bump of the given width around a place.
double bump(glm::dvec3 p, glm::dvec3 place, double width) {
    return std::exp(-glm::dot(p - place, p - place) / (width * width));
}

/// A smooth field, one with a steep front, and the three components of a flow.
Mesh with_fields(Mesh mesh) {
    meshes::add_scalar(mesh, "wave", meshes::wave_field);
    meshes::add_scalar(mesh, "front", [](glm::dvec3 p) { return std::tanh(8 * (p.x + 0.5 * p.y - 0.3)); });
    for (int axis = 0; axis < 3; ++axis)
        meshes::add_scalar(mesh, std::string("v") + "xyz"[axis],
                           [axis](glm::dvec3 p) { return meshes::whirl_field(p)[axis]; });
    return mesh;
}

/// Fractal mountains with their height, and the temperature of two hot places.
Mesh mountains() {
    Mesh mesh = meshes::terrain(7, 8);
    meshes::add_scalar(mesh, "height", [](glm::dvec3 p) { return p.z; });
    meshes::add_scalar(mesh, "temperature", [](glm::dvec3 p) {
        return 300 - 20 * p.z + 40 * bump(p, {0.3, 0.4, 0}, 0.2) + 25 * bump(p, {0.7, 0.6, 0}, 0.1);
    });
    return mesh;
}

void write_float(std::ofstream& file, double value) {
    const auto single = static_cast<float>(value);
    file.write(reinterpret_cast<const char*>(&single), sizeof single);
}

void write_ply(const std::filesystem::path& path, const Mesh& mesh) {
    std::ofstream file(path, std::ios::binary);
    file << "ply\nformat binary_little_endian 1.0\nelement vertex " << vertex_count(mesh)
         << "\nproperty float x\nproperty float y\nproperty float z\n";
    for (const meshbound::Variable& variable : mesh.variables) file << "property float " << variable.name << '\n';
    file << "element face " << mesh.triangles.size() << "\nproperty list uchar uint vertex_indices\nend_header\n";
    for (std::size_t v = 0; v < vertex_count(mesh); ++v) {
        for (int axis = 0; axis < 3; ++axis) write_float(file, value_at(mesh.position, v, axis));
        for (const meshbound::Variable& variable : mesh.variables) write_float(file, value_at(variable, v, 0));
    }
    for (const glm::uvec3& triangle : mesh.triangles) {
        const std::uint32_t corners[3] = {triangle.x, triangle.y, triangle.z};
        file.put(3).write(reinterpret_cast<const char*>(corners), sizeof corners);
    }
    if (!file) throw std::runtime_error(path.string() + ": cannot be written");
}

void write_all(const std::filesystem::path& folder) {
    write_ply(folder / "sphere.ply", with_fields(meshes::sphere(32)));
    write_ply(folder / "noisy-sphere.ply", with_fields(meshes::noisy_sphere(24, 0.01, 5)));
    write_ply(folder / "torus.ply", with_fields(meshes::torus(128, 48)));
    write_ply(folder / "plate.ply", with_fields(meshes::mapped(meshes::smoothed(meshes::pierced_plate(3, 10), 4),
                                                               [](glm::dvec3 p) { return p / 35.0; })));
    write_ply(folder / "pleats.ply", with_fields(meshes::pleats(7, 22)));
    write_ply(folder / "twisted-band.ply", with_fields(meshes::twisted_band(200, 24)));
    write_ply(folder / "terrain.ply", mountains());
}

} // namespace

int main(int count, char** arguments) {
    if (count != 2) {
        std::cerr << "usage: peers_surfaces FOLDER\n";
        return 2;
    }
    try {
        write_all(arguments[1]);
    } catch (const std::exception& fault) {
        std::cerr << "peers_surfaces: " << fault.what() << '\n';
        return 1;
    }
}
