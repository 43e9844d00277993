#pragma once

#include <vector>

#include "errors/tracked/mapped_content.hpp"
#include "metric/bounded_rows.hpp"
#include "surface/hole.hpp"
#include "surface/surface.hpp"

namespace meshbound {

/// Puts the vertices of a curve on the closing edges of the stars of one removal: each at the same share of all of
/// them, where their errors are smallest together if images are optimized.
class ClosingShares {
public:
    ClosingShares(const Surface& surface, const BoundedRows& rows, bool optimize)
        : surface_(surface), rows_(rows), optimize_(optimize) {}

    struct Star {
        const Hole* hole;
        MappedContent* content;
    };
    void agree(const std::vector<Star>& stars, double squared_threshold);

private:
    /// A vertex of the curve, as one of the stars has it.
    struct CurveVertex {
        const Star* star;
        std::size_t inner; ///< index of the inner vertex
        bool forward;      ///< its closing edge runs as that of the first star
    };
    double share_of(const std::vector<CurveVertex>& curve_vertices, double squared_threshold) const;
    double error(const std::vector<CurveVertex>& curve_vertices, double share) const;

    const Surface& surface_;
    const BoundedRows& rows_;
    bool optimize_;
};

} // namespace meshbound
