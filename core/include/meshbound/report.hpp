#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "meshbound/bounds.hpp"
#include "meshbound/mesh_defects.hpp"

namespace meshbound {

/// What was guaranteed and reached for one variable. Errors and bounds are in the variable's unit.
struct VariableReport {
    std::string name;
    int components = 1;
    VariableKind kind = VariableKind::quantity;
    ResolvedBound bound;
    /// No point of the surface has a larger error than this. NaN where that is not known: the variable is NaN or infinite
    /// somewhere (ResolvedBound::non_finite), or its values lie farther apart than a double holds; so it is free.
    double error = 0;
    double ratio = 0; ///< largest of error / bound, multiplied as it is there; 1 is the limit; 0 where it is free
    std::size_t refused = 0; ///< vertices still there because removing them would break this variable's bound
};

/// Why vertices that are still there could not go, besides the bounds (see VariableReport::refused). Each is counted once, for
/// the first of these reasons that it has, or for its bound.
struct Refusals {
    /// Where curves meet or end (edges of three or more triangles, borders of regions, seams), or in a bow-tie.
    std::size_t non_manifold = 0;
    std::size_t locked = 0;   ///< by Options::locked, or of what locked boxes and regions hold
    std::size_t ring = 0;     ///< it has more than 48 neighbours, too many to fill the hole that it would leave
    std::size_t topology = 0; ///< removal would change the topology: existing edge, tetrahedron, last loop (§3.2.3)
    std::size_t fold = 0;     ///< every retriangulation turns away from the surface or folds onto a neighbour
    std::size_t piercing =
        0; ///< what stays within the bounds would pierce another lobe (with Options::refuse_piercing)
};

/// Parts of the surface that were left out because they are smaller than the bound of position (Options::drop_small_components).
struct DroppedComponents {
    std::size_t components = 0, triangles = 0;
};

/// How much there is of a region (Mesh::regions). One without triangles has vanished.
struct RegionReport {
    std::int32_t label = 0;
    std::size_t triangles_before = 0, triangles_after = 0;
    double area_before = 0, area_after = 0; ///< in the unit of position, squared; infinity beyond what a double holds
};

enum class Termination {
    finished,     ///< no single vertex can go any more
    cancelled,    ///< the caller cancelled; the mesh is valid and within the bounds, but larger than need be
    intermediate, ///< a checkpoint of a reduction that went on
};

struct Report {
    std::size_t triangles_before = 0, triangles_after = 0;
    std::size_t vertices_before = 0, vertices_after = 0;
    std::vector<VariableReport> variables; ///< position first, then the mesh's variables in their order
    /// Vertices of the input that were there to go, locked ones too: all that triangles use, but for those of dropped parts.
    std::size_t candidates = 0;
    Refusals refused; ///< together with those of the variables, all vertices left; nothing where it was cancelled
    MeshDefects defects;
    DroppedComponents dropped;
    /// Which of Options::locked_boxes meet no triangle, so that nothing stays because of them; rising indices.
    /// Of a resumed reduction: no triangle of the checkpoint.
    std::vector<std::size_t> unused_locked_boxes;
    std::vector<RegionReport> regions; ///< by rising labels; empty where triangles have none
    /// The feature size, where it limited the bound of position (Options::limit_to_feature_size).
    std::optional<double> feature_size;
    std::size_t non_manifold_vertices = 0; ///< of the input: on edges of three or more triangles, in bow-ties
    /// Triangles that turn more than a right angle against the surface that they stand for: against the original's normal at
    /// one of their corners, which is the sum of the area vectors of the original's triangles there. None turns farther at a
    /// corner than some triangle of the original does. Not counted where the reduction was cancelled or went on from a checkpoint.
    std::size_t flipped_normals_before = 0, flipped_normals_after = 0;
    /// Tracked errors only: into how many cells the map cuts the original (figure 5), and how many of them it turns over
    /// (see Segmentation). Folds of the map are no folds of the surface; they matter to morphing.
    std::size_t cells = 0, folded_cells = 0;
    Termination termination = Termination::finished;
    /// Errors are upper bounds, sums over a checkpoint and the way on from there (see resume_reduction).
    bool errors_are_upper_bounds = false;
};

} // namespace meshbound
