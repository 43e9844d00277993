#include "from_js.hpp"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>

namespace meshbound::js {

using emscripten::typed_memory_view;
using emscripten::val;

namespace {

/// Copies a typed array into memory that was allocated for it. The view dies at the next allocation, so it is not kept.
template <class T>
void copy_into(T* memory, std::size_t count, const val& array) {
    val(typed_memory_view(count, memory)).call<void>("set", array);
}

template <class T>
std::vector<T> vector_from(const val& array) {
    std::vector<T> copy(array["length"].as<std::size_t>());
    copy_into(copy.data(), copy.size(), array);
    return copy;
}

Values values_from(const val& array) {
    if (array.instanceof (val::global("Float64Array"))) {
        return vector_from<double>(array);
    }
    return vector_from<float>(array);
}

VariableKind kind_from(const val& kind) {
    return kind.isString() && kind.as<std::string>() == "identifier" ? VariableKind::identifier
                                                                     : VariableKind::quantity;
}

Bound bound_from(const std::string& name, const val& bound) {
    if (bound.isString() && bound.as<std::string>() == "free") {
        return unbounded();
    }
    if (!bound.isString() && !bound.isNull() && !bound.isUndefined()) {
        if (bound["relative"].isNumber()) {
            return relative(bound["relative"].as<double>());
        }
        if (bound["absolute"].isNumber()) {
            return absolute(bound["absolute"].as<double>());
        }
    }
    throw ShapeError{{Fault::bad_bound,
                      "The bound of “" + name + "” is none of { relative: number }, { absolute: number } and “free”.",
                      name,
                      {}}};
}

[[noreturn]] void refuse_option(const char* option, const std::string& given) {
    throw ShapeError{{Fault::bad_option, "The option " + std::string(option) + " cannot be “" + given + "”.", {}, {}}};
}

/// Reads an option that is true or false; left out, it stays as it is.
void read_flag(const val& options, const char* option, bool& flag) {
    const val given = options[option];
    if (given.isUndefined()) {
        return;
    }
    if (!given.isTrue() && !given.isFalse()) {
        refuse_option(option, val::global("String")(given).as<std::string>());
    }
    flag = given.isTrue();
}

ErrorAccounting errors_from(const std::string& name) {
    if (name == "propagated") {
        return ErrorAccounting::propagated;
    }
    if (name == "tracked") {
        return ErrorAccounting::tracked;
    }
    refuse_option("errors", name);
}

RetriangulationCost cost_from(const std::string& name) {
    if (name == "maximum") {
        return RetriangulationCost::maximum;
    }
    if (name == "introduced") {
        return RetriangulationCost::introduced;
    }
    refuse_option("cost", name);
}

glm::dvec3 point_from(const val& numbers) {
    const auto number = [&](int axis) {
        const val given = numbers[axis];
        return given.isNumber() ? given.as<double>() : std::numeric_limits<double>::quiet_NaN();
    };
    return {number(0), number(1), number(2)};
}

std::vector<Box> boxes_from(const val& boxes) {
    std::vector<Box> result;
    const auto count = boxes["length"].as<std::size_t>();
    for (std::size_t i = 0; i < count; ++i) {
        result.push_back({point_from(boxes[i]["lowest"]), point_from(boxes[i]["highest"])});
    }
    return result;
}

/// So that what belongs together can be read side by side.
void check_length(const char* array, std::size_t length, std::size_t each, std::size_t count, const char* of) {
    if (length == each * count) return;
    throw ShapeError{{Fault::bad_map,
                      "The map's " + std::string(array) + " has " + std::to_string(length) + " numbers; " +
                          std::to_string(count) + " " + of + " need " + std::to_string(each) + " each.",
                      {},
                      {}}};
}

SurfaceMap map_from(const val& map) {
    const auto triangle = vector_from<std::uint32_t>(map["triangle"]);
    const auto barycentric = vector_from<double>(map["barycentric"]);
    const auto edges = vector_from<std::uint32_t>(map["crossingEdges"]);
    const auto places = vector_from<double>(map["crossingShares"]);
    const auto rightward = vector_from<std::uint8_t>(map["crossingRightward"]);
    check_length("barycentric", barycentric.size(), 3, triangle.size(), "vertices");
    check_length("crossingEdges", edges.size(), 4, rightward.size(), "crossings");
    check_length("crossingShares", places.size(), 2, rightward.size(), "crossings");
    SurfaceMap result;
    for (std::size_t i = 0; i < triangle.size(); ++i) {
        const double* shares = &barycentric[3 * i];
        result.images.push_back({triangle[i], {shares[0], shares[1], shares[2]}});
    }
    for (std::size_t i = 0; i < rightward.size(); ++i) {
        const std::uint32_t* ends = &edges[4 * i];
        result.crossings.push_back(
            {{ends[0], ends[1]}, places[2 * i], {ends[2], ends[3]}, places[2 * i + 1], rightward[i] != 0});
    }
    return result;
}

/// JavaScript has one type of number. What is no count is 0, which the core refuses where it counts on it.
std::size_t count_from(const val& number) {
    const double value = number.isNumber() ? number.as<double>() : 0;
    return value >= 0 && value < static_cast<double>(std::numeric_limits<std::uint32_t>::max())
               ? static_cast<std::size_t>(value)
               : 0;
}

double number_from(const val& number) {
    return number.isNumber() ? number.as<double>() : std::numeric_limits<double>::quiet_NaN();
}

template <class T, class Convert>
std::vector<T> list_from(const val& list, Convert convert) {
    std::vector<T> result;
    const auto count = list["length"].as<std::size_t>();
    for (std::size_t i = 0; i < count; ++i) {
        result.push_back(convert(list[i]));
    }
    return result;
}

/// A part of a checkpoint, refused where it is not there.
val present(const val& part, const char* name) {
    if (!part.isUndefined() && !part.isNull()) {
        return part;
    }
    throw ShapeError{
        {Fault::bad_checkpoint, "The checkpoint has no “" + std::string(name) + "” where it should.", {}, {}}};
}

val part_of(const val& whole, const char* name) { return present(whole[name], name); }

template <class T, class Convert>
std::vector<T> list_in(const val& whole, const char* name, Convert convert) {
    return list_from<T>(part_of(whole, name), [&](const val& element) { return convert(present(element, name)); });
}

unsigned threads_from(const val& threads) {
    const double value = number_from(threads);
    if (value >= 1 && value <= 64 && value == std::floor(value)) {
        return static_cast<unsigned>(value);
    }
    throw ShapeError{{Fault::bad_option, "The number of threads must be a whole number from 1 to 64.", {}, {}}};
}

std::string text_from(const val& text) { return text.isString() ? text.as<std::string>() : std::string(); }

VariableReport variable_report_from(const val& report) {
    VariableReport result;
    result.name = text_from(report["name"]);
    result.kind = kind_from(report["kind"]);
    result.bound.extent = number_from(report["extent"]);
    result.bound.magnitude = number_from(report["magnitude"]);
    result.bound.constant = report["constant"].isTrue();
    if (const val non_finite = report["nonFinite"]; !non_finite.isUndefined() && !non_finite.isNull()) {
        result.bound.non_finite = count_from(non_finite["vertices"]);
        result.bound.first_non_finite = count_from(non_finite["first"]);
    }
    result.error = number_from(report["error"]);
    return result;
}

RegionReport region_report_from(const val& region) {
    RegionReport result;
    result.label = part_of(region, "label").as<std::int32_t>();
    result.triangles_before = count_from(part_of(region, "triangles")["before"]);
    result.area_before = number_from(part_of(region, "area")["before"]);
    return result;
}

MeshDefects defects_from(const val& defects) {
    MeshDefects result;
    result.repeated_vertex_triangles = count_from(defects["repeatedVertexTriangles"]);
    result.zero_area_triangles = count_from(defects["zeroAreaTriangles"]);
    result.unused_vertices = count_from(defects["unusedVertices"]);
    result.flipped_triangles = count_from(defects["flippedTriangles"]);
    result.unorientable_components = count_from(defects["unorientableComponents"]);
    result.copied_triangles = count_from(defects["copiedTriangles"]);
    result.two_sided_triangles = count_from(defects["twoSidedTriangles"]);
    if (const val triangle = defects["unorientableTriangle"]; triangle.isNumber()) {
        result.unorientable_triangle = count_from(triangle);
    }
    return result;
}

/// What a checkpoint's report says of the original, and what was spent; the core reads nothing else of it.
Report report_from(const val& report) {
    Report result;
    result.triangles_before = count_from(part_of(report, "triangles")["before"]);
    result.vertices_before = count_from(part_of(report, "vertices")["before"]);
    result.candidates = count_from(report["candidates"]);
    result.variables = list_in<VariableReport>(report, "variables", variable_report_from);
    result.defects = defects_from(part_of(report, "defects"));
    const val dropped = part_of(report, "dropped");
    result.dropped = {count_from(dropped["components"]), count_from(dropped["triangles"])};
    result.regions = list_in<RegionReport>(report, "regions", region_report_from);
    result.non_manifold_vertices = count_from(report["nonManifoldVertices"]);
    return result;
}

} // namespace

Mesh mesh_from(const val& mesh) {
    Mesh result;
    result.position.values = values_from(mesh["position"]);

    const val triangles = mesh["triangles"];
    result.triangles.resize(triangles["length"].as<std::size_t>() / 3);
    static_assert(sizeof(glm::uvec3) == 3 * sizeof(std::uint32_t), "triangles are three indices without gaps");
    if (!result.triangles.empty()) {
        copy_into(&result.triangles.front().x, result.triangles.size() * 3, triangles);
    }

    if (const val regions = mesh["regions"]; !regions.isUndefined()) {
        result.regions = vector_from<std::int32_t>(regions);
    }

    const val variables = mesh["variables"];
    const auto count = variables["length"].as<std::size_t>();
    for (std::size_t i = 0; i < count; ++i) {
        const val variable = variables[i];
        result.variables.push_back({variable["name"].as<std::string>(), variable["components"].as<int>(),
                                    values_from(variable["values"]), kind_from(variable["kind"])});
    }
    return result;
}

Bounds bounds_from(const val& bounds) {
    const val entries = val::global("Object").call<val>("entries", bounds);
    Bounds result;
    for (std::size_t i = 0; i < entries["length"].as<std::size_t>(); ++i) {
        const auto name = entries[i][0].as<std::string>();
        result.push_back({name, bound_from(name, entries[i][1])});
    }
    return result;
}

Options options_from(const val& options) {
    Options result;
    if (const val sweeps = options["sweeps"]; !sweeps.isUndefined()) {
        result.sweeps = list_from<double>(sweeps, number_from);
    }
    if (const val threads = options["threads"]; !threads.isUndefined()) {
        result.threads = threads_from(threads);
    }
    if (const val errors = options["errors"]; !errors.isUndefined()) {
        result.errors = errors_from(errors.as<std::string>());
    }
    if (const val cost = options["cost"]; !cost.isUndefined()) {
        result.cost = cost_from(cost.as<std::string>());
    }
    read_flag(options, "countFolds", result.count_folds);
    read_flag(options, "refusePiercing", result.refuse_piercing);
    read_flag(options, "limitToFeatureSize", result.limit_to_feature_size);
    read_flag(options, "dropSmallComponents", result.drop_small_components);
    read_flag(options, "optimizeVertexImages", result.optimize_vertex_images);
    read_flag(options, "optimizeEdgeCrossings", result.optimize_edge_crossings);
    if (const val locked = options["locked"]; !locked.isUndefined()) {
        result.locked = vector_from<std::uint32_t>(locked);
    }
    if (const val regions = options["lockedRegions"]; !regions.isUndefined()) {
        result.locked_regions = vector_from<std::int32_t>(regions);
    }
    if (const val boxes = options["lockedBoxes"]; !boxes.isUndefined()) {
        result.locked_boxes = boxes_from(boxes);
    }
    if (const val focus = options["boundMultiplier"]; !focus.isUndefined()) {
        result.bound_multiplier = focus.as<std::string>();
    }
    return result;
}

std::vector<Bounds> level_bounds_from(const val& levels) { return list_from<Bounds>(levels, bounds_from); }

LevelOptions level_options_from(const val& options) {
    LevelOptions result;
    result.reduction = options_from(options);
    read_flag(options, "morphs", result.morphs);
    return result;
}

bool wants_checkpoint(const val& options) {
    bool wanted = false;
    read_flag(options, "checkpoint", wanted);
    return wanted;
}

Checkpoint checkpoint_from(const val& checkpoint) {
    return {mesh_from(checkpoint["mesh"]), vector_from<std::uint32_t>(checkpoint["vertices"]),
            report_from(part_of(checkpoint, "report"))};
}

Reduction mapped_reduction_from(const val& reduction) {
    Reduction result;
    result.mesh = mesh_from(reduction["mesh"]);
    result.vertices = vector_from<std::uint32_t>(reduction["vertices"]);
    result.map = map_from(reduction["map"]);
    return result;
}

} // namespace meshbound::js
