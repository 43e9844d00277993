#include "meshes/ply.hpp"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <utility>

static_assert(std::endian::native == std::endian::little, "the samples are little-endian");

namespace meshes {
namespace {

struct Header {
    std::size_t vertices = 0, faces = 0;
    std::vector<std::string> names; ///< of the vertex properties
    std::string type;               ///< of all of them
};

[[noreturn]] void fail(const std::string& path, const std::string& what) {
    throw std::runtime_error(path + ": " + what);
}

bool is_number_type(const std::string& type) { return type == "float" || type == "double"; }

Header read_header(std::ifstream& file, const std::string& path) {
    Header header;
    std::string line, element;
    if (!std::getline(file, line) || line != "ply") fail(path, "not a PLY file");
    while (std::getline(file, line) && line != "end_header") {
        std::istringstream words(line);
        std::string word, type, name;
        words >> word >> type >> name;
        if (word == "format" && type != "binary_little_endian") fail(path, "not binary and little-endian");
        if (word == "element") {
            element = type;
            (element == "vertex" ? header.vertices : header.faces) = std::stoul(name);
        }
        if (word != "property" || element != "vertex") continue;
        if (!is_number_type(type) || (!header.type.empty() && type != header.type))
            fail(path, "not a property in one of two precisions: " + name);
        header.type = type;
        header.names.push_back(name);
    }
    if (header.names.size() < 3) fail(path, "no vertex positions");
    return header;
}

template <typename Value>
void read_vertices(std::ifstream& file, const Header& header, meshbound::Mesh& mesh) {
    const std::size_t width = header.names.size();
    std::vector<Value> all(width * header.vertices);
    file.read(reinterpret_cast<char*>(all.data()), static_cast<std::streamsize>(all.size() * sizeof(Value)));
    std::vector<Value> position(3 * header.vertices);
    for (std::size_t column = 0; column < width; ++column) {
        const std::string& name = header.names[column];
        if (name == "x" || name == "y" || name == "z") {
            const std::size_t axis = static_cast<std::size_t>(name[0] - 'x');
            for (std::size_t v = 0; v < header.vertices; ++v) position[3 * v + axis] = all[v * width + column];
            continue;
        }
        std::vector<Value> values(header.vertices);
        for (std::size_t v = 0; v < header.vertices; ++v) values[v] = all[v * width + column];
        mesh.variables.push_back({name, 1, std::move(values)});
    }
    mesh.position.values = std::move(position);
}

void read_triangles(std::ifstream& file, const Header& header, const std::string& path, meshbound::Mesh& mesh) {
    constexpr std::size_t bytes_a_face = 1 + 3 * sizeof(std::uint32_t);
    std::vector<char> bytes(bytes_a_face * header.faces);
    file.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    if (!file) fail(path, "ends early");
    mesh.triangles.resize(header.faces);
    for (std::size_t f = 0; f < header.faces; ++f) {
        const char* face = bytes.data() + f * bytes_a_face;
        if (*face != 3) fail(path, "a face that is no triangle");
        std::uint32_t corners[3];
        std::memcpy(corners, face + 1, sizeof corners);
        mesh.triangles[f] = {corners[0], corners[1], corners[2]};
    }
}

void add_files(const char* folder, std::vector<std::string>& files) {
    if (!folder || !std::filesystem::is_directory(folder)) return;
    for (const auto& entry : std::filesystem::directory_iterator(folder))
        if (entry.path().extension() == ".ply") files.push_back(entry.path().string());
}

} // namespace

meshbound::Mesh read_ply(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    if (!file) fail(path, "cannot be opened");
    const Header header = read_header(file, path);
    meshbound::Mesh mesh;
    if (header.type == "double") read_vertices<double>(file, header, mesh);
    else read_vertices<float>(file, header, mesh);
    read_triangles(file, header, path, mesh);
    return mesh;
}

std::vector<std::string> sample_files() {
    const char* samples = std::getenv("MESHBOUND_SAMPLES");
#ifdef MESHBOUND_SAMPLES
    if (!samples) samples = MESHBOUND_SAMPLES;
#endif
    std::vector<std::string> files;
    add_files(samples, files);
    add_files(std::getenv("MESHBOUND_DATA"), files);
    std::sort(files.begin(), files.end());
    return files;
}

} // namespace meshes
