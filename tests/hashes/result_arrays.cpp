#include "hashes/result_arrays.hpp"

#include <variant>

using namespace meshbound;

namespace {

const char* type_name(float) { return "Float32Array"; }
const char* type_name(double) { return "Float64Array"; }
const char* type_name(std::uint8_t) { return "Uint8Array"; }
const char* type_name(std::uint32_t) { return "Uint32Array"; }
const char* type_name(std::int32_t) { return "Int32Array"; }

} // namespace

template <class T>
void ResultArrays::array(const std::string& name, const std::vector<T>& values) {
    take(name, type_name(T{}), values.size(), values.data(), values.size() * sizeof(T));
}

void ResultArrays::array(const std::string& name, const Values& values) {
    std::visit([&](const auto& numbers) { array(name, numbers); }, values);
}

void ResultArrays::array(const std::string& name, const std::vector<glm::uvec3>& triangles) {
    take(name, type_name(std::uint32_t{}), 3 * triangles.size(), triangles.data(),
         triangles.size() * sizeof(glm::uvec3));
}

void ResultArrays::mesh(const Mesh& mesh) {
    array("position", mesh.position.values);
    array("triangles", mesh.triangles);
    for (const Variable& variable : mesh.variables) array("variable:" + variable.name, variable.values);
    if (!mesh.regions.empty()) array("regions", mesh.regions);
}

void ResultArrays::map(const SurfaceMap& map) {
    std::vector<std::uint32_t> triangle, edges;
    std::vector<double> barycentric, places;
    std::vector<std::uint8_t> rightward;
    for (const SurfacePoint& place : map.images) {
        triangle.push_back(place.triangle);
        for (int corner = 0; corner < 3; ++corner) barycentric.push_back(place.barycentric[corner]);
    }
    for (const MapCrossing& crossing : map.crossings) {
        edges.insert(edges.end(), {crossing.original.x, crossing.original.y, crossing.reduced.x, crossing.reduced.y});
        places.insert(places.end(), {crossing.s, crossing.t});
        rightward.push_back(crossing.rightward ? 1 : 0);
    }
    array("map:triangle", triangle);
    array("map:barycentric", barycentric);
    array("map:crossingEdges", edges);
    array("map:crossingShares", places);
    array("map:crossingRightward", rightward);
}

void ResultArrays::report(const Report& report) {
    const auto number = [](std::size_t count) { return static_cast<double>(count); };
    array<double>("report:counts", {number(report.triangles_before),
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
                                    number(report.flipped_normals_before),
                                    number(report.flipped_normals_after),
                                    number(report.defects.repeated_vertex_triangles),
                                    number(report.defects.zero_area_triangles),
                                    number(report.defects.unused_vertices),
                                    number(report.non_manifold_vertices),
                                    number(report.cells),
                                    number(report.folded_cells),
                                    number(report.dropped.components),
                                    number(report.dropped.triangles),
                                    report.feature_size.value_or(0)});
    std::vector<double> regions;
    for (const RegionReport& region : report.regions)
        regions.insert(regions.end(), {static_cast<double>(region.label), number(region.triangles_before),
                                       number(region.triangles_after), region.area_before, region.area_after});
    array("report:regions", regions);
    for (const VariableReport& variable : report.variables)
        array<double>("report:" + variable.name,
                      {variable.bound.extent, variable.bound.magnitude, variable.bound.constant ? 1.0 : 0.0,
                       variable.bound.absolute, variable.error, variable.ratio, number(variable.refused)});
}

void ResultArrays::reduction(const Reduction& reduction) {
    mesh(reduction.mesh);
    array("vertices", reduction.vertices);
    for (std::size_t variable = 0; variable < reduction.triangle_errors.size(); ++variable) {
        const std::string name = ":" + reduction.report.variables[variable].name;
        const TriangleErrors& errors = reduction.triangle_errors[variable];
        array("largest" + name, errors.largest);
        array("lowest" + name, errors.lowest);
        array("highest" + name, errors.highest);
        array("ratio" + name, errors.ratio);
    }
    for (std::size_t variable = 0; variable < reduction.vertex_errors.size(); ++variable) {
        const std::string name = ":" + reduction.report.variables[variable].name;
        array("vertexError" + name, reduction.vertex_errors[variable].error);
        array("vertexSignedError" + name, reduction.vertex_errors[variable].signed_error);
    }
    if (!reduction.map.images.empty()) map(reduction.map);
    report(reduction.report);
}

void ResultArrays::levels(const Levels& levels) {
    for (std::size_t i = 0; i < levels.levels.size(); ++i) {
        const std::string name = std::to_string(i);
        array("level" + name, levels.levels[i].mesh.triangles);
        array("vertices" + name, levels.levels[i].vertices);
        const Morph& morph = levels.morphs[i];
        array("morph" + name, morph.triangles);
        for (std::size_t v = 0; v < morph.finer.variables.size(); ++v) {
            array("finer" + name + ":" + morph.finer.variables[v].name, morph.finer.variables[v].values);
            array("coarser" + name + ":" + morph.coarser.variables[v].name, morph.coarser.variables[v].values);
        }
    }
}

void ResultArrays::segmentation(const Segmentation& segmentation) {
    std::vector<std::uint32_t> cells;
    for (const SegmentationCell& cell : segmentation.cells)
        cells.insert(cells.end(),
                     {cell.original, cell.reduced, cell.first_corner, cell.corner_count, cell.first_piece});
    array("cells", cells);
    array("corners", segmentation.corners);
    array("pieces", segmentation.pieces);
    array<double>("folds",
                  {static_cast<double>(segmentation.folded_cells), static_cast<double>(segmentation.folded_pieces),
                   segmentation.folded_original, segmentation.folded_reduced});
}
