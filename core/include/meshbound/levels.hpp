#pragma once

#include <vector>

#include "meshbound/api.hpp"
#include "meshbound/bounds.hpp"
#include "meshbound/level_map.hpp"
#include "meshbound/mesh.hpp"
#include "meshbound/morph.hpp"
#include "meshbound/options.hpp"
#include "meshbound/reduction.hpp"
#include "meshbound/status.hpp"

namespace meshbound {

struct LevelOptions {
    Options reduction;
    /// Tracked errors only: keep the map from each level onto the next coarser one, to morph between them (see Morph). It
    /// moves nothing farther than the bounds of both levels together, which may leave a few more triangles.
    bool maps = false;
    /// Tracked errors only: make the morphs between neighbours, from the original to the first level too. Needs links, so
    /// they are kept.
    bool morphs = false;
};

/// Nested levels of detail, finest first.
struct Levels {
    /// Each against the ORIGINAL: its errors, its map and its vertices' indices, as if it were reduced alone.
    std::vector<Reduction> levels;
    /// links[i] leads from levels[i] to levels[i + 1]. Empty where none were asked for. From the original to levels[0]
    /// leads the map of levels[0].
    std::vector<LevelMap> maps;
    /// morphs[i] leads to levels[i], from the level before or, i being 0, from the original. Empty where none were asked for.
    std::vector<Morph> morphs;
};

/// Reduces a mesh to nested levels of detail, one for each of the bounds, finest first (§4). Each level continues from the
/// one before, so its vertices are a subset of the finer one's, bit for bit; and each keeps its own bounds against the
/// original, as `reduce` guarantees. The first level is what `reduce` makes of the first bounds; a coarser one has seldom
/// quite as few triangles as a reduction from scratch.
///
/// From level to level no bound may fall and at least one must rise; there is at least one level.
///
/// Faults: those of reduce; bad_levels, with the level (from 0) as index and the variable at fault. `levels` is then
/// untouched. A cancelled call returns an ok status and the levels so far, the last one marked as cancelled and without a
/// link or a morph to it.
MESHBOUND_API Status reduce_levels(const Mesh& mesh, const std::vector<Bounds>& bounds, const LevelOptions& options,
                                   Levels& levels, const Progress& progress = {});

} // namespace meshbound
