#include "meshbound/morph.hpp"

#include <algorithm>
#include <cstdint>
#include <new>
#include <type_traits>
#include <utility>
#include <variant>

#include "meshbound/segmentation.hpp"
#include "segmentation/check_map.hpp"
#include "util/out_of_memory.hpp"

namespace meshbound {
namespace {

using MorphPlaces = std::vector<MorphPoint>;

MorphPoint on_edge(const glm::uvec2& edge, double share) { return {{edge.x, edge.y, edge.x}, {1 - share, share, 0}}; }

MorphPlaces on_finer(const MappedSurfaces& surfaces) {
    MorphPlaces corners;
    for (std::uint32_t vertex = 0; vertex < surfaces.map.images.size(); ++vertex)
        corners.push_back({glm::uvec3(vertex), {1, 0, 0}});
    for (const MapCrossing& crossing : surfaces.map.crossings)
        corners.push_back(on_edge(crossing.original, crossing.s));
    return corners;
}

/// A vertex that no triangle uses has no image: any point will do (see leave_unused).
MorphPlaces on_coarser(const MappedSurfaces& surfaces) {
    MorphPlaces corners;
    for (const SurfacePoint& place : surfaces.map.images)
        corners.push_back(place.triangle == nowhere
                              ? MorphPoint{}
                              : MorphPoint{surfaces.reduced.triangles[place.triangle], place.barycentric});
    for (const MapCrossing& crossing : surfaces.map.crossings) corners.push_back(on_edge(crossing.reduced, crossing.t));
    return corners;
}

/// What stands at a vertex that no triangle uses stays as it is.
void leave_unused(const SurfaceMap& map, const std::vector<Variable>& finer, std::vector<Variable>& coarser) {
    for (std::size_t i = 0; i < finer.size(); ++i)
        std::visit(
            [&](auto& values) {
                const auto& still = std::get<std::decay_t<decltype(values)>>(finer[i].values);
                const auto components = static_cast<std::size_t>(finer[i].components);
                for (std::size_t vertex = 0; vertex < map.images.size(); ++vertex)
                    if (map.images[vertex].triangle == nowhere)
                        std::copy_n(&still[vertex * components], components, &values[vertex * components]);
            },
            coarser[i].values);
}

/// One component at a point. A weight of 1 gives the vertex's own value, bit for bit (a negative zero, too).
template <class Number>
Number mixed(const std::vector<Number>& values, int components, const MorphPoint& place, int component) {
    double sum = 0;
    for (int i = 0; i < 3; ++i) {
        if (place.weights[i] == 0) continue;
        const Number value =
            values[place.vertices[i] * static_cast<std::size_t>(components) + static_cast<std::size_t>(component)];
        if (place.weights[i] == 1) return value;
        sum += place.weights[i] * static_cast<double>(value);
    }
    return static_cast<Number>(sum);
}

/// A variable at the corners, in its own precision.
Variable at_corners(const VariableView& variable, const MorphPlaces& corners) {
    const auto mix = [&](const auto& values) -> Values {
        std::decay_t<decltype(values)> mixtures;
        mixtures.reserve(corners.size() * static_cast<std::size_t>(variable.components));
        for (const MorphPoint& corner : corners)
            for (int component = 0; component < variable.components; ++component)
                mixtures.push_back(mixed(values, variable.components, corner, component));
        return mixtures;
    };
    return {std::string(variable.name), variable.components, std::visit(mix, variable.values), variable.kind};
}

void place_corners(const Mesh& mesh, MorphPlaces corners, MorphEnd& end) {
    for (std::size_t i = 0; i < variable_count(mesh); ++i)
        end.variables.push_back(at_corners(variable_of(mesh, i), corners));
    end.points = std::move(corners);
}

/// At either end what stands there, also where the other end has no number.
Variable mixed(const Variable& finer, const Variable& coarser, double share) {
    if (share == 0) return finer;
    if (share == 1) return coarser;
    Variable result = finer;
    std::visit(
        [&](auto& values) {
            const auto& others = std::get<std::decay_t<decltype(values)>>(coarser.values);
            for (std::size_t i = 0; i < values.size(); ++i)
                values[i] = static_cast<typename std::decay_t<decltype(values)>::value_type>((1 - share) * values[i] +
                                                                                             share * others[i]);
        },
        result.values);
    return result;
}

Morph morph_by(const MappedSurfaces& surfaces, Segmentation segmentation) {
    Morph morph;
    for (const SegmentationCell& cell : segmentation.cells) {
        morph.finer.triangles.insert(morph.finer.triangles.end(), cell.corner_count - 2, cell.original);
        morph.coarser.triangles.insert(morph.coarser.triangles.end(), cell.corner_count - 2, cell.reduced);
    }
    morph.triangles = std::move(segmentation.pieces);
    morph.folded_triangles = segmentation.folded_pieces;
    morph.folded_share = segmentation.folded_original;
    if (morph.triangles.empty()) return morph;
    place_corners(surfaces.original, on_finer(surfaces), morph.finer);
    place_corners(surfaces.reduced, on_coarser(surfaces), morph.coarser);
    leave_unused(surfaces.map, morph.finer.variables, morph.coarser.variables);
    return morph;
}

} // namespace

Status make_morph(const MappedSurfaces& surfaces, Morph& morph, const Progress& progress) {
    try {
        Segmentation segmentation;
        if (Status status = segment(surfaces, segmentation, progress); !status.ok()) return status;
        if (Status status = check_same_variables(surfaces); !status.ok()) return status;
        morph = morph_by(surfaces, std::move(segmentation));
        return {};
    } catch (const std::bad_alloc&) {
        return out_of_memory("morphing", surfaces.original.triangles.size());
    }
}

Mesh morphed(const Morph& morph, double share) {
    Mesh mesh;
    mesh.triangles = morph.triangles;
    for (std::size_t i = 0; i < morph.finer.variables.size(); ++i) {
        Variable variable = mixed(morph.finer.variables[i], morph.coarser.variables[i], share);
        if (i == 0) mesh.position.values = std::move(variable.values);
        else mesh.variables.push_back(std::move(variable));
    }
    return mesh;
}

} // namespace meshbound
