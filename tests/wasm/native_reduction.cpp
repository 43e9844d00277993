/// Reduces the gallery and meshes that are not manifold natively, for the comparison with the WebAssembly module:
///
///     native_reduction FOLDER
///
/// FOLDER gets, for each mesh, NAME.mesh and one file of the result a mode and a setting, NAME.SETTING.MODE, NAME.levels of
/// levels of detail and NAME.onward of a reduction that goes on from the waypoint of another one; of the setting "kept", whose meshes have labels and a variable that multiplies bounds, NAME.kept.mesh:
/// arrays one after the other, each a line "name type count" and then its bytes (tests/wasm/labelled-arrays.ts reads them).

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <fstream>
#include <iostream>
#include <stdexcept>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "meshbound/meshbound.hpp"
#include "meshes/fields.hpp"
#include "meshes/gallery.hpp"
#include "meshes/oddities.hpp"
#include "meshes/shapes.hpp"
#include "meshes/variations.hpp"

namespace {

using namespace meshbound;

std::string type_name(float) { return "Float32Array"; }
std::string type_name(double) { return "Float64Array"; }
std::string type_name(std::uint8_t) { return "Uint8Array"; }
std::string type_name(std::uint32_t) { return "Uint32Array"; }
std::string type_name(std::int32_t) { return "Int32Array"; }

/// Writes arrays with their names.
class LabelledArrays {
public:
    explicit LabelledArrays(const std::string& path) : file(path, std::ios::binary) {}

    template <class T>
    void write(const std::string& name, const T* values, std::size_t count) {
        file << name << ' ' << type_name(T{}) << ' ' << count << '\n';
        file.write(reinterpret_cast<const char*>(values), static_cast<std::streamsize>(count * sizeof(T)));
    }

    template <class T>
    void write(const std::string& name, const std::vector<T>& values) {
        write(name, values.data(), values.size());
    }

    void write(const std::string& name, const Values& values) {
        std::visit([&](const auto& numbers) { write(name, numbers); }, values);
    }

    void finish() {
        if (!file.flush()) throw std::runtime_error("A file cannot be written.");
    }

private:
    std::ofstream file;
};

void write_triangles(LabelledArrays& arrays, const std::string& name, const std::vector<glm::uvec3>& triangles) {
    arrays.write(name, triangles.empty() ? nullptr : &triangles.front().x, 3 * triangles.size());
}

void write_mesh(LabelledArrays& arrays, const Mesh& mesh) {
    arrays.write("position", mesh.position.values);
    write_triangles(arrays, "triangles", mesh.triangles);
    for (const Variable& variable : mesh.variables) arrays.write("variable:" + variable.name, variable.values);
    if (!mesh.regions.empty()) arrays.write("regions", mesh.regions);
}

void write_map(LabelledArrays& arrays, const SurfaceMap& map) {
    std::vector<std::uint32_t> triangle, edges;
    std::vector<double> barycentric, places;
    std::vector<std::uint8_t> rightward;
    for (const MapPlace& place : map.places) {
        triangle.push_back(place.triangle);
        for (int corner = 0; corner < 3; ++corner) barycentric.push_back(place.barycentric[corner]);
    }
    for (const MapCrossing& crossing : map.crossings) {
        edges.insert(edges.end(), {crossing.original.x, crossing.original.y, crossing.reduced.x, crossing.reduced.y});
        places.insert(places.end(), {crossing.s, crossing.t});
        rightward.push_back(crossing.rightward ? 1 : 0);
    }
    arrays.write("map:triangle", triangle);
    arrays.write("map:barycentric", barycentric);
    arrays.write("map:crossingEdges", edges);
    arrays.write("map:crossingPlaces", places);
    arrays.write("map:crossingRightward", rightward);
}

void write_report(LabelledArrays& arrays, const Report& report) {
    const auto number = [](std::size_t count) { return static_cast<double>(count); };
    arrays.write<double>("report:counts", {number(report.triangles_before),
                                           number(report.triangles_after),
                                           number(report.vertices_before),
                                           number(report.vertices_after),
                                           number(report.candidates),
                                           number(report.refused.non_manifold),
                                           number(report.refused.locked),
                                           number(report.refused.ring),
                                           number(report.refused.topology),
                                           number(report.refused.fold),
                                           number(report.refused.piercing),
                                           number(report.turned_before),
                                           number(report.turned_after),
                                           number(report.oddities.repeated_vertex_triangles),
                                           number(report.oddities.zero_area_triangles),
                                           number(report.oddities.unused_vertices),
                                           number(report.non_manifold_vertices),
                                           number(report.cells),
                                           number(report.folded_cells),
                                           number(report.dropped.parts),
                                           number(report.dropped.triangles),
                                           report.feature_size.value_or(0)});
    std::vector<double> regions;
    for (const RegionReport& region : report.regions)
        regions.insert(regions.end(), {static_cast<double>(region.label), number(region.triangles_before),
                                       number(region.triangles_after), region.area_before, region.area_after});
    arrays.write("report:regions", regions);
    for (const VariableReport& variable : report.variables)
        arrays.write<double>("report:" + variable.name,
                             {variable.bound.extent, variable.bound.magnitude, variable.bound.constant ? 1.0 : 0.0,
                              variable.bound.absolute, variable.error, variable.ratio, number(variable.refused)});
}

void write_reduction(const std::string& path, const Reduction& reduction) {
    LabelledArrays arrays(path);
    write_mesh(arrays, reduction.mesh);
    arrays.write("vertices", reduction.vertices);
    for (std::size_t variable = 0; variable < reduction.triangle_errors.size(); ++variable) {
        const std::string name = ":" + reduction.report.variables[variable].name;
        const TriangleErrors& errors = reduction.triangle_errors[variable];
        arrays.write("largest" + name, errors.largest);
        arrays.write("lowest" + name, errors.lowest);
        arrays.write("highest" + name, errors.highest);
        arrays.write("ratio" + name, errors.ratio);
    }
    for (std::size_t variable = 0; variable < reduction.vertex_errors.size(); ++variable) {
        const std::string name = ":" + reduction.report.variables[variable].name;
        arrays.write("vertexError" + name, reduction.vertex_errors[variable].error);
        arrays.write("vertexSignedError" + name, reduction.vertex_errors[variable].signed_error);
    }
    if (!reduction.map.places.empty()) write_map(arrays, reduction.map);
    write_report(arrays, reduction.report);
    arrays.finish();
}

void write_levels(const std::string& path, const Levels& levels) {
    LabelledArrays arrays(path);
    for (std::size_t i = 0; i < levels.levels.size(); ++i) {
        const std::string name = std::to_string(i);
        write_triangles(arrays, "level" + name, levels.levels[i].mesh.triangles);
        arrays.write("vertices" + name, levels.levels[i].vertices);
        const Morph& morph = levels.morphs[i];
        write_triangles(arrays, "morph" + name, morph.triangles);
        for (std::size_t v = 0; v < morph.finer.variables.size(); ++v) {
            arrays.write("finer" + name + ":" + morph.finer.variables[v].name, morph.finer.variables[v].values);
            arrays.write("coarser" + name + ":" + morph.coarser.variables[v].name, morph.coarser.variables[v].values);
        }
    }
    arrays.finish();
}

struct Mode {
    std::string name;
    Errors errors;
    Cost cost;
};

const std::vector<Mode> modes = {{"tracked", Errors::tracked, Cost::introduced},
                                 {"propagated-maximum", Errors::propagated, Cost::maximum},
                                 {"propagated-introduced", Errors::propagated, Cost::introduced}};

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
    options.focus = "multiplier";
    options.drop_small_parts = true;
    options.locked = {1};
    options.locked_regions = {2};
    const std::size_t middle = vertex_count(mesh) / 2;
    Box box;
    for (int axis = 0; axis < 3; ++axis) box.lowest[axis] = box.highest[axis] = value_at(mesh.position, middle, axis);
    options.locked_boxes = {box};
    return {"kept", fractions(0.03, 0.1), options};
}

void write_input(const std::string& path, const Mesh& mesh) {
    LabelledArrays input(path + ".mesh");
    write_mesh(input, mesh);
    input.finish();
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
    write_levels(path + ".levels", levels);
}

void go_onward(const std::string& path, const Mesh& mesh) {
    Waypoint waypoint;
    Reduction reduction;
    Status status = reduce(mesh, fractions(0.01, 0.03), {}, reduction, {}, &waypoint);
    if (status.ok()) status = reduce_onward(waypoint, fractions(0.03, 0.06), {}, reduction);
    if (!status.ok()) throw std::runtime_error(path + ": " + status.message);
    write_reduction(path + ".onward", reduction);
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
