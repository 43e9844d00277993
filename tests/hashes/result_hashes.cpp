/// Reduces a small set of meshes in many ways and prints a hash of all bytes of each result, one a line:
///
///     result_hashes > found.txt
///
/// tests/hashes/expected.txt has what every system must print (result-hashes.test.ts compares). The meshes are made by
/// +, −, ×, ÷ and roots alone, so that they, too, are the same everywhere.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "hashes/result_arrays.hpp"
#include "meshbound/meshbound.hpp"
#include "meshes/defects.hpp"
#include "meshes/fields.hpp"
#include "meshes/shapes.hpp"
#include "meshes/variations.hpp"
#include "meshes/voxel_surface.hpp"

namespace {

using namespace meshbound;

/// The hash of all arrays with their names (FNV-1a, 64 bits).
class Hash final : public ResultArrays {
public:
    std::uint64_t value() const { return value_; }

private:
    void take(const std::string& name, const char* type, std::size_t, const void* bytes, std::size_t size) override {
        add(name.data(), name.size());
        add(type, std::char_traits<char>::length(type));
        add(static_cast<const char*>(bytes), size);
    }

    void add(const char* bytes, std::size_t size) {
        for (std::size_t i = 0; i < size; ++i)
            value_ = (value_ ^ static_cast<unsigned char>(bytes[i])) * std::uint64_t{0x100000001b3};
    }

    std::uint64_t value_ = 0xcbf29ce484222325;
};

void print(const Hash& hash, const std::string& what) {
    std::printf("%016llx %s\n", static_cast<unsigned long long>(hash.value()), what.c_str());
}

void require(const Status& status, const std::string& what) {
    if (!status.ok()) throw std::runtime_error(what + ": " + status.message);
}

Bounds fractions(double geometry, double variables) {
    return {{"position", relative(geometry)}, {"*", relative(variables)}};
}

struct Named {
    std::string name;
    Mesh mesh;
};

/// With what is smooth, what jumps, and what has components.
Mesh with_data(Mesh mesh) {
    meshes::add_scalar(mesh, "linear", meshes::linear_field);
    meshes::add_scalar(mesh, "hill", [](glm::dvec3 p) { return 1 / (1 + 4 * (p.x * p.x + p.y * p.y + p.z * p.z)); });
    meshes::add_scalar(mesh, "jump", meshes::jump_field(0.3));
    meshes::add_scalar(mesh, "multiplier", [](glm::dvec3 p) { return 1 / (1 + p.x * p.x); });
    meshes::add_vector(mesh, "whirl", [](glm::dvec3 p) { return glm::dvec3(-p.y, p.x, 0.25 * p.z * p.z); });
    return mesh;
}

std::vector<Named> surfaces() {
    const Mesh sphere = with_data(meshes::noisy_sphere(12, 0.003, 1));
    std::vector<Named> all = {
        {"sphere", sphere},
        {"sphere in single precision", meshes::in_single(sphere)},
        {"irregular sphere", meshes::shuffled(meshes::jittered(meshes::flipped(sphere, 400, 2), 0.01, 3), 4)},
        {"pleats", with_data(meshes::pleats(4, 6))},
        {"terrain", with_data(meshes::terrain(5, 7))},
        {"two holes", with_data(meshes::mapped(meshes::pierced_plate(2, 3), [](glm::dvec3 p) { return 0.1 * p; }))},
        {"three sheets", with_data(meshes::three_sheets(8))},
        {"bow tie", with_data(meshes::bow_tie(10))},
        {"one triangle reversed", with_data(meshes::one_triangle_reversed(12))},
        {"degenerate triangles", meshes::with_degenerate_triangles(with_data(meshes::cubes_on_one_edge(6)))},
    };
    for (auto& [name, mesh] : all) { // two regions
        mesh.regions.assign(mesh.triangles.size(), 3);
        std::fill(mesh.regions.begin() + static_cast<std::ptrdiff_t>(mesh.regions.size() / 2), mesh.regions.end(), 8);
    }
    return all;
}

struct Setting {
    std::string name;
    Bounds bounds;
    Options options;
};

std::vector<Setting> settings() {
    Options propagated, maximum, apart, kept;
    propagated.errors = maximum.errors = ErrorAccounting::propagated;
    maximum.cost = RetriangulationCost::maximum;
    apart.refuse_piercing = apart.limit_to_feature_size = true;
    kept.bound_multiplier = "multiplier";
    kept.drop_small_components = true;
    kept.locked = {1};
    kept.locked_regions = {8};
    return {{"usual", fractions(0.01, 0.03), {}},
            {"coarse", fractions(0.06, 0.2), {}},
            {"propagated", fractions(0.01, 0.03), propagated},
            {"maximum", fractions(0.01, 0.03), maximum},
            {"apart", fractions(0.02, 0.06), apart},
            {"kept", fractions(0.03, 0.1), kept}};
}

void print_reduction(const Named& surface, const Setting& setting) {
    const std::string what = surface.name + ", " + setting.name;
    Reduction reduction;
    require(reduce(surface.mesh, setting.bounds, setting.options, reduction), what);
    Hash hash;
    hash.reduction(reduction);
    Segmentation segmentation;
    require(segment({surface.mesh, reduction}, segmentation), what);
    hash.segmentation(segmentation);
    print(hash, what);
}

void print_levels(const Named& surface) {
    LevelOptions options;
    options.morphs = true;
    Levels levels;
    const std::string what = surface.name + ", levels";
    require(reduce_levels(surface.mesh, {fractions(0.01, 0.03), fractions(0.03, 0.06)}, options, levels), what);
    Hash hash;
    hash.levels(levels);
    print(hash, what);
}

void print_onward(const Named& surface) {
    const std::string what = surface.name + ", onward";
    Checkpoint checkpoint;
    Reduction reduction;
    require(reduce(surface.mesh, fractions(0.01, 0.03), {}, reduction, {}, &checkpoint), what);
    require(resume_reduction(checkpoint, fractions(0.03, 0.06), {}, reduction), what);
    Hash hash;
    hash.reduction(reduction);
    print(hash, what);
}

} // namespace

int main() {
    try {
        for (const Named& surface : surfaces()) {
            Hash input;
            input.mesh(surface.mesh);
            print(input, surface.name);
            for (const Setting& setting : settings()) print_reduction(surface, setting);
            print_levels(surface);
            print_onward(surface);
        }
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
}
