#include "to_js.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <utility>
#include <variant>

namespace meshbound::js {

using emscripten::typed_memory_view;
using emscripten::val;

namespace {

/// A JavaScript object from names and values.
template <class... Values>
val object(std::pair<const char*, Values>... fields) {
    val result = val::object();
    (result.set(fields.first, fields.second), ...);
    return result;
}

template <class T>
std::pair<const char*, T> field(const char* name, T value) {
    return {name, std::move(value)};
}

/// JavaScript has one type of number; counts stay exact in it up to 2^53.
double number(std::size_t count) { return static_cast<double>(count); }

template <class T>
val array_to(const T* values, std::size_t count) {
    return val(typed_memory_view(count, values)).template call<val>("slice");
}

template <class T>
val array_to(const std::vector<T>& values) {
    return array_to(values.data(), values.size());
}

/// How many elements are gathered before they are handed over together: few enough to stay in the cache.
constexpr std::size_t block_size = 1024;

/// Numbers that do not lie side by side in C++ as one typed array: `per_element` numbers for each element, as
/// `write(element, numbers)` writes them. They pass through one small block, so that nothing is held twice.
template <class T, std::size_t per_element, class Element, class Write>
val gathered_to(const std::vector<Element>& elements, Write write) {
    std::array<T, block_size * per_element> block;
    val array = val(typed_memory_view(0, block.data()))["constructor"].new_(number(elements.size() * per_element));
    for (std::size_t first = 0; first < elements.size(); first += block_size) {
        const std::size_t size = std::min(block_size, elements.size() - first);
        for (std::size_t i = 0; i < size; ++i) {
            write(elements[first + i], block.data() + i * per_element);
        }
        array.call<void>("set", val(typed_memory_view(size * per_element, block.data())), number(first * per_element));
    }
    return array;
}

/// A JavaScript array of what `convert` makes of each element.
template <class Range, class Convert>
val list_to(const Range& range, Convert convert) {
    val list = val::array();
    for (const auto& element : range) {
        list.call<void>("push", convert(element));
    }
    return list;
}

val values_to(const Values& values) {
    return std::visit([](const auto& numbers) { return array_to(numbers); }, values);
}

/// A quantity is what a variable is where nothing is said.
val with_kind(val object, VariableKind kind) {
    if (kind == VariableKind::identifier) {
        object.set("kind", std::string("identifier"));
    }
    return object;
}

/// Left out where all values are numbers.
val with_non_finite(val measured, const ResolvedBound& bound) {
    if (bound.non_finite > 0) {
        measured.set("nonFinite", object(field("vertices", number(bound.non_finite)),
                                         field("first", number(bound.first_non_finite))));
    }
    return measured;
}

val variable_to(const Variable& variable) {
    return with_kind(object(field("name", variable.name), field("components", variable.components),
                            field("values", values_to(variable.values))),
                     variable.kind);
}

val triangles_to(const std::vector<glm::uvec3>& triangles) {
    return array_to(triangles.empty() ? nullptr : &triangles.front().x, triangles.size() * 3);
}

val mesh_to(const Mesh& mesh) {
    val result =
        object(field("position", values_to(mesh.position.values)), field("triangles", triangles_to(mesh.triangles)),
               field("variables", list_to(mesh.variables, variable_to)));
    if (!mesh.regions.empty()) {
        result.set("regions", array_to(mesh.regions));
    }
    return result;
}

val triangle_errors_to(const TriangleErrors& errors) {
    return object(field("largest", array_to(errors.largest)), field("lowest", array_to(errors.lowest)),
                  field("highest", array_to(errors.highest)), field("ratio", array_to(errors.ratio)));
}

val map_to(const SurfaceMap& map) {
    const auto triangle = [](const SurfacePoint& place, std::uint32_t* to) { *to = place.triangle; };
    const auto barycentric = [](const SurfacePoint& place, double* to) { std::copy_n(&place.barycentric.x, 3, to); };
    const auto edges = [](const MapCrossing& crossing, std::uint32_t* to) {
        std::copy_n(&crossing.original.x, 2, to);
        std::copy_n(&crossing.reduced.x, 2, to + 2);
    };
    const auto places = [](const MapCrossing& crossing, double* to) {
        to[0] = crossing.s;
        to[1] = crossing.t;
    };
    const auto rightward = [](const MapCrossing& crossing, std::uint8_t* to) { *to = crossing.rightward ? 1 : 0; };
    return object(field("triangle", gathered_to<std::uint32_t, 1>(map.images, triangle)),
                  field("barycentric", gathered_to<double, 3>(map.images, barycentric)),
                  field("crossingEdges", gathered_to<std::uint32_t, 4>(map.crossings, edges)),
                  field("crossingShares", gathered_to<double, 2>(map.crossings, places)),
                  field("crossingRightward", gathered_to<std::uint8_t, 1>(map.crossings, rightward)));
}

val vertex_errors_to(const VertexErrors& errors) {
    return object(field("error", array_to(errors.error)), field("signedError", array_to(errors.signed_error)));
}

/// Position apart from the variables, as in a mesh.
val morph_end_to(const MorphEnd& end) {
    val position = val::array(), others = val::array();
    for (std::size_t i = 0; i < end.variables.size(); ++i) {
        if (i == 0) position = values_to(end.variables[i].values);
        else others.call<void>("push", variable_to(end.variables[i]));
    }
    const auto vertices = [](const MorphPoint& place, std::uint32_t* to) { std::copy_n(&place.vertices.x, 3, to); };
    const auto weights = [](const MorphPoint& place, double* to) { std::copy_n(&place.weights.x, 3, to); };
    return object(field("position", position), field("variables", others), field("triangle", array_to(end.triangles)),
                  field("vertices", gathered_to<std::uint32_t, 3>(end.points, vertices)),
                  field("weights", gathered_to<double, 3>(end.points, weights)));
}

val morph_to(const Morph& morph) {
    return object(field("triangles", triangles_to(morph.triangles)), field("finer", morph_end_to(morph.finer)),
                  field("coarser", morph_end_to(morph.coarser)),
                  field("foldedTriangles", number(morph.folded_triangles)), field("foldedShare", morph.folded_share));
}

val variable_report_to(const VariableReport& report) {
    const val result =
        object(field("name", report.name), field("components", report.components), field("extent", report.bound.extent),
               field("magnitude", report.bound.magnitude), field("constant", report.bound.constant),
               field("bound", report.bound.absolute), field("error", report.error), field("ratio", report.ratio),
               field("refused", number(report.refused)));
    return with_non_finite(with_kind(result, report.kind), report.bound);
}

val before_after(std::size_t before, std::size_t after) {
    return object(field("before", number(before)), field("after", number(after)));
}

val defects_to(const MeshDefects& defects) {
    val result = object(field("repeatedVertexTriangles", number(defects.repeated_vertex_triangles)),
                        field("zeroAreaTriangles", number(defects.zero_area_triangles)),
                        field("unusedVertices", number(defects.unused_vertices)),
                        field("flippedTriangles", number(defects.flipped_triangles)),
                        field("unorientableComponents", number(defects.unorientable_components)),
                        field("copiedTriangles", number(defects.copied_triangles)),
                        field("twoSidedTriangles", number(defects.two_sided_triangles)));
    if (defects.unorientable_triangle) {
        result.set("unorientableTriangle", number(*defects.unorientable_triangle));
    }
    return result;
}

val refusals_to(const Refusals& refused) {
    return object(field("nonManifold", number(refused.non_manifold)), field("locked", number(refused.locked)),
                  field("ring", number(refused.ring)), field("topology", number(refused.topology)),
                  field("fold", number(refused.fold)), field("piercing", number(refused.piercing)));
}

val region_report_to(const RegionReport& region) {
    return object(field("label", region.label),
                  field("triangles", before_after(region.triangles_before, region.triangles_after)),
                  field("area", object(field("before", region.area_before), field("after", region.area_after))));
}

std::string termination_name(Termination termination) {
    switch (termination) {
    case Termination::finished: return "finished";
    case Termination::cancelled: return "cancelled";
    case Termination::intermediate: return "intermediate";
    }
    return "";
}

val report_to(const Report& report, double seconds) {
    val result = object(
        field("triangles", before_after(report.triangles_before, report.triangles_after)),
        field("vertices", before_after(report.vertices_before, report.vertices_after)),
        field("variables", list_to(report.variables, variable_report_to)),
        field("candidates", number(report.candidates)), field("refused", refusals_to(report.refused)),
        field("defects", defects_to(report.defects)),
        field("dropped", object(field("components", number(report.dropped.components)),
                                field("triangles", number(report.dropped.triangles)))),
        field("unusedLockedBoxes", list_to(report.unused_locked_boxes, number)),
        field("regions", list_to(report.regions, region_report_to)),
        field("flippedNormals", before_after(report.flipped_normals_before, report.flipped_normals_after)),
        field("nonManifoldVertices", number(report.non_manifold_vertices)), field("cells", number(report.cells)),
        field("foldedCells", number(report.folded_cells)), field("termination", termination_name(report.termination)),
        field("errorsAreUpperBounds", report.errors_are_upper_bounds), field("seconds", seconds));
    if (report.feature_size) {
        result.set("featureSize", *report.feature_size);
    }
    return result;
}

val checkpoint_to(const Checkpoint& checkpoint, double seconds) {
    return object(field("mesh", mesh_to(checkpoint.mesh)), field("vertices", array_to(checkpoint.vertices)),
                  field("report", report_to(checkpoint.report, seconds)));
}

val extent_to(const VariableView& variable, const ResolvedBound& bound) {
    const val result =
        object(field("name", std::string(variable.name)), field("components", variable.components),
               field("extent", bound.extent), field("magnitude", bound.magnitude), field("constant", bound.constant));
    return with_non_finite(with_kind(result, variable.kind), bound);
}

} // namespace

val reduction_to(const Reduction& reduction, double seconds, const Checkpoint* checkpoint) {
    val result = object(field("mesh", mesh_to(reduction.mesh)), field("vertices", array_to(reduction.vertices)),
                        field("triangleErrors", list_to(reduction.triangle_errors, triangle_errors_to)),
                        field("report", report_to(reduction.report, seconds)));
    if (!reduction.map.images.empty()) {
        result.set("map", map_to(reduction.map));
        result.set("vertexErrors", list_to(reduction.vertex_errors, vertex_errors_to));
    }
    if (checkpoint && !checkpoint->vertices.empty()) {
        result.set("checkpoint", checkpoint_to(*checkpoint, seconds));
    }
    return result;
}

val levels_to(Levels levels, double seconds) {
    val reductions = val::array(), morphs = val::array();
    for (Reduction& level : levels.levels) {
        reductions.call<void>("push", reduction_to(level, seconds));
        level = {};
    }
    for (Morph& morph : levels.morphs) {
        morphs.call<void>("push", morph_to(morph));
        morph = {};
    }
    return object(field("levels", reductions), field("morphs", morphs));
}

val segmentation_to(const Segmentation& segmentation) {
    std::vector<std::uint32_t> originals, reduced;
    originals.reserve(segmentation.pieces.size());
    reduced.reserve(segmentation.pieces.size());
    for (const SegmentationCell& cell : segmentation.cells) {
        originals.insert(originals.end(), cell.corner_count - 2, cell.original);
        reduced.insert(reduced.end(), cell.corner_count - 2, cell.reduced);
    }
    return object(field("pieces", triangles_to(segmentation.pieces)), field("original", array_to(originals)),
                  field("reduced", array_to(reduced)), field("foldedPieces", number(segmentation.folded_pieces)));
}

val inspection_to(const Mesh& mesh, const MeshDefects& defects, const std::vector<ResolvedBound>& bounds) {
    val variables = val::array();
    for (std::size_t i = 0; i < variable_count(mesh); ++i) {
        variables.call<void>("push", extent_to(variable_of(mesh, i), bounds[i]));
    }
    return object(field("triangles", number(mesh.triangles.size())), field("vertices", number(vertex_count(mesh))),
                  field("variables", variables), field("defects", defects_to(defects)));
}

} // namespace meshbound::js
