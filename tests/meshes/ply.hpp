#pragma once

#include <string>
#include <vector>

#include "meshbound/mesh.hpp"

namespace meshes {

/// Reads a binary little-endian PLY file of triangles. Vertex properties in single or double precision; x, y, z are the
/// position, every other one is a variable of one component. Throws std::runtime_error where the file is anything else.
meshbound::Mesh read_ply(const std::string& path);

/// All .ply files in the folder of the samples (the environment variable MESHBOUND_SAMPLES, else the folder that the build
/// fills) and in that of MESHBOUND_DATA, where these exist; sorted.
std::vector<std::string> sample_files();

} // namespace meshes
