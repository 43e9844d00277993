#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "meshbound/glm_layout.hpp"
#include "meshbound/progress.hpp"

namespace meshbound {

/// How errors are accounted for. Both give the guarantee.
enum class ErrorAccounting {
    propagated, ///< the paper's scheme (§3.3.3): signed intervals on the triangles, added up removal by removal
    tracked,    ///< the map from the original surface is kept and measured against the original at every step
};

/// What the retriangulation of a hole makes small (§3.4.1); with propagated errors. Errors are ratios to the bounds, the largest over all variables.
enum class RetriangulationCost {
    maximum,    ///< the largest accumulated error: keep away from the bounds
    introduced, ///< the largest error that this removal introduces
};

/// A box along the axes, in the unit of position; its faces belong to it.
struct Box {
    glm::dvec3 lowest{0}, highest{0};
};

struct Options {
    ErrorAccounting errors = ErrorAccounting::tracked;
    RetriangulationCost cost = RetriangulationCost::introduced;

    /// The sweeps over the surface: each removes what stays within this fraction of the bounds. Rising, in (0, 1], the last
    /// one 1. Early, tighter sweeps take the harmless vertices first; one at 1/8 and one at 1 left the fewest triangles.
    std::vector<double> sweeps = {0.125, 1.0};

    /// Tracked errors only: where the map is free, choose places of vertices and of crossings with smaller errors (the
    /// layout's places else). Fewer triangles; some folds in the map, none in the surface.
    bool optimize_vertex_images = true;
    bool optimize_edge_crossings = true;

    /// Refuse every retriangulation with a triangle that would pierce or touch another lobe of the surface that passes near,
    /// or meet any other triangle beyond the corners and edges that they have in common (§3.2.3). Two triangles of the
    /// result then meet only if both are triangles of the input, which met before. Decided exactly, as long as no coordinate
    /// but 0 is below 1e-150 of the largest.
    bool refuse_piercing = false;

    /// Limit the bound of position to half the feature size (see feature_size): two lobes, both of which may move, then stay
    /// apart. The paper's way (§3.2.3), coarser than refuse_piercing and without its certainty. Position must not be free.
    bool limit_to_feature_size = false;

    /// Tracked errors only: count the folds of the map when the reduction is done, which takes a few percent of its time.
    bool count_folds = true;

    /// How many threads share the work, this one among them, at most 64; 0: as many as the machine runs at once. The result
    /// is the same for any number, byte for byte.
    unsigned threads = 0;

    /// Vertices (indices into the input) that must stay.
    std::vector<std::uint32_t> locked;

    /// What must stay as it is: every triangle whose own box meets one of these boxes, with its vertices.
    std::vector<Box> locked_boxes;

    /// Labels (Mesh::regions) of regions that must stay as they are, borders included. Each must exist.
    std::vector<std::int32_t> locked_regions;

    /// Whether parts of the surface whose box has a diagonal within the bound of position are left out and counted
    /// (Report::dropped); the guarantee is then about the rest. A part hangs together over vertices, or over vertices in one
    /// place. The largest part stays, as do parts with locked vertices. Where the bound is multiplied, its least value in the
    /// part counts; of levels those of the first one. Position must not be free there.
    bool drop_small_components = false;

    /// The name of a variable with one component, above zero everywhere, which multiplies every bound; empty: none does. So
    /// bounds vary over the surface: at a point p where the original has the multiplier m, no error exceeds m times the
    /// bound. The variable itself is carried along like any other.
    std::string bound_multiplier;
};

} // namespace meshbound
