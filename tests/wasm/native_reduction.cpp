/// Reduces the gallery and meshes that are not manifold natively, for the comparison with the WebAssembly module:
///
///     native_reduction FOLDER
///
/// FOLDER gets, for each mesh, NAME.mesh and one file of the result a mode and a setting, NAME.SETTING.MODE, NAME.levels of
/// levels of detail and NAME.onward of a reduction that goes on from the checkpoint of another one; of the setting "kept", whose meshes have labels and a variable that multiplies bounds, NAME.kept.mesh:
/// arrays one after the other, each a line "name type count" and then its bytes (tests/wasm/labelled-arrays.ts reads them).

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <fstream>
#include <iostream>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "hashes/result_arrays.hpp"
#include "meshbound/meshbound.hpp"
#include "meshes/defects.hpp"
#include "meshes/fields.hpp"
#include "meshes/gallery.hpp"
#include "meshes/shapes.hpp"
#include "meshes/variations.hpp"

namespace {

using namespace meshbound;

/// Writes arrays with their names to a file.
class ArrayFile final : public ResultArrays {
public:
    explicit ArrayFile(const std::string& path) : file_(path, std::ios::binary) {}

    void finish() {
        if (!file_.flush()) throw std::runtime_error("A file cannot be written.");
    }

private:
    void take(const std::string& name, const char* type, std::size_t count, const void* bytes,
              std::size_t size) override {
        file_ << name << ' ' << type << ' ' << count << '\n';
        file_.write(static_cast<const char*>(bytes), static_cast<std::streamsize>(size));
    }

    std::ofstream file_;
};

struct Mode {
    std::string name;
    ErrorAccounting errors;
    RetriangulationCost cost;
};

const std::vector<Mode> modes = {
    {"tracked", ErrorAccounting::tracked, RetriangulationCost::introduced},
    {"propagated-maximum", ErrorAccounting::propagated, RetriangulationCost::maximum},
    {"propagated-introduced", ErrorAccounting::propagated, RetriangulationCost::introduced}};

/// How a mesh is reduced in every mode; native.test.ts has the same.
struct Setting {
    std::string name;
    Bounds bounds;
    Options options;
};

Bounds fractions(double geometry, double variables) {
    return {{"position", relative(geometry)}, {"*", relative(variables)}};
}

std::vector<Setting> settings() {
    Options apart;
    apart.refuse_piercing = apart.limit_to_feature_size = true;
    return {{"usual", fractions(0.01, 0.03), {}},
            {"fine", fractions(0.002, 0.006), {}},
            {"coarse", fractions(0.06, 0.2), {}},
            {"apart", fractions(0.02, 0.06), apart}};
}

/// With four regions one after the other, and a variable that multiplies the bounds along x.
Mesh with_labels_and_focus(Mesh mesh) {
    const std::size_t triangles = mesh.triangles.size();
    for (std::size_t t = 0; t < triangles; ++t) mesh.regions.push_back(static_cast<std::int32_t>(4 * t / triangles));
    double low = value_at(mesh.position, 0, 0), high = low;
    for (std::size_t v = 0; v < vertex_count(mesh); ++v) {
        low = std::min(low, value_at(mesh.position, v, 0));
        high = std::max(high, value_at(mesh.position, v, 0));
    }
    std::vector<double> multipliers;
    for (std::size_t v = 0; v < vertex_count(mesh); ++v)
        multipliers.push_back(0.5 + (value_at(mesh.position, v, 0) - low) / (high - low));
    mesh.variables.push_back({"multiplier", 1, std::move(multipliers)});
    return mesh;
}

/// A vertex, the triangles around another one, and a region are locked.
Setting kept(const Mesh& mesh) {
    Options options;
    options.bound_multiplier = "multiplier";
    options.drop_small_components = true;
    options.locked = {1};
    options.locked_regions = {2};
    const std::size_t middle = vertex_count(mesh) / 2;
    Box box;
    for (int axis = 0; axis < 3; ++axis) box.lowest[axis] = box.highest[axis] = value_at(mesh.position, middle, axis);
    options.locked_boxes = {box};
    return {"kept", fractions(0.03, 0.1), options};
}

void write_input(const std::string& path, const Mesh& mesh) {
    ArrayFile input(path + ".mesh");
    input.mesh(mesh);
    input.finish();
}

void write_reduction(const std::string& path, const Reduction& reduction) {
    ArrayFile file(path);
    file.reduction(reduction);
    file.finish();
}

void reduce_in_every_mode(const std::string& path, const Mesh& mesh, const Setting& setting) {
    for (const Mode& mode : modes) {
        Options options = setting.options;
        options.errors = mode.errors;
        options.cost = mode.cost;
        Reduction reduction;
        if (const Status status = reduce(mesh, setting.bounds, options, reduction); !status.ok())
            throw std::runtime_error(path + ": " + status.message);
        write_reduction(path + "." + setting.name + "." + mode.name, reduction);
    }
}

void reduce_to_levels(const std::string& path, const Mesh& mesh) {
    const std::vector<Bounds> bounds = {{{"position", relative(0.01)}, {"*", relative(0.03)}},
                                        {{"position", relative(0.03)}, {"*", relative(0.06)}}};
    LevelOptions options;
    options.morphs = true;
    Levels levels;
    if (const Status status = reduce_levels(mesh, bounds, options, levels); !status.ok())
        throw std::runtime_error(path + ": " + status.message);
    ArrayFile file(path + ".levels");
    file.levels(levels);
    file.finish();
}

void go_onward(const std::string& path, const Mesh& mesh) {
    Checkpoint checkpoint;
    Reduction reduction;
    Status status = reduce(mesh, fractions(0.01, 0.03), {}, reduction, {}, &checkpoint);
    if (status.ok()) status = resume_reduction(checkpoint, fractions(0.03, 0.06), {}, reduction);
    if (!status.ok()) throw std::runtime_error(path + ": " + status.message);
    write_reduction(path + ".onward", reduction);
}

std::vector<double> with_strays(std::vector<double> values, int components, double stray) {
    values.insert(values.end(), 2 * static_cast<std::size_t>(components), stray);
    return values;
}

/// With an identifier called "ids", which no bound for all is about and which is no number in places, and two points of no
/// triangle, which are nowhere; native.test.ts knows the kind by the name.
Mesh with_ids_and_strays(Mesh mesh) {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    mesh.position.values = with_strays(std::get<std::vector<double>>(mesh.position.values), 3, nan);
    for (Variable& variable : mesh.variables)
        variable.values = with_strays(std::get<std::vector<double>>(variable.values), variable.components, nan);
    std::vector<double> ids(vertex_count(mesh));
    for (std::size_t v = 0; v < ids.size(); ++v) ids[v] = v % 50 == 7 ? nan : 1000 + static_cast<double>(v);
    mesh.variables.push_back({"ids", 1, std::move(ids), VariableKind::identifier});
    return mesh;
}

std::vector<meshes::Exhibit> exhibits() {
    std::vector<meshes::Exhibit> all = meshes::gallery();
    // Small beside the wave of the usual fields, so that some of it can go.
    const auto add = [&](const std::string& name, const Mesh& original) {
        Mesh mesh = meshes::mapped(original, [](glm::dvec3 p) { return 0.1 * p; });
        meshes::add_usual_fields(mesh);
        all.push_back({name, mesh, false});
    };
    add("three sheets", meshes::three_sheets(8));
    add("bow tie", meshes::bow_tie(10));
    add("cubes on one edge", meshes::cubes_on_one_edge(6));
    add("one triangle reversed", meshes::one_triangle_reversed(12));
    add("shared out in patches", meshes::noisy_sphere(30, 0.01, 1));
    add("degenerate triangles", meshes::with_degenerate_triangles(meshes::three_sheets(6)));
    all.push_back({"ids and strays", with_ids_and_strays(all.back().mesh), false});
    return all;
}

} // namespace

int main(int, char** argv) {
    try {
        for (const meshes::Exhibit& exhibit : exhibits()) {
            const std::string path = std::string(argv[1]) + "/" + exhibit.name;
            write_input(path, exhibit.mesh);
            for (const Setting& setting : settings()) reduce_in_every_mode(path, exhibit.mesh, setting);
            const Mesh labelled = with_labels_and_focus(exhibit.mesh);
            write_input(path + ".kept", labelled);
            reduce_in_every_mode(path, labelled, kept(labelled));
            reduce_to_levels(path, exhibit.mesh);
            go_onward(path, labelled);
        }
    } catch (const std::exception& error) {
        std::cerr << error.what() << "\n";
        return 1;
    }
}
