#pragma once

#include <vector>

#include "surface/hole.hpp"
#include "errors/tracked/hole_content.hpp"
#include "metric/measured_rows.hpp"
#include "surface/surface.hpp"

namespace meshbound {

/// Where on the closing edges of the parts of one removal along a curve the vertices of the curve go: each to the same share
/// on all of them, where their errors are smallest together if the map is free.
class ClosingShares {
public:
    ClosingShares(const Surface& surface, const MeasuredRows& rows, bool choose)
        : surface_(surface), rows_(rows), choose_(choose) {}

    struct Part {
        const Hole* hole;
        HoleContent* content;
    };
    void agree(const std::vector<Part>& parts, double squared_content);

private:
    /// A vertex of the curve in one part.
    struct Copy {
        const Part* part;
        std::size_t inner; ///< of its content
        bool forward;      ///< its closing edge runs as that of the first part
    };
    double share_of(const std::vector<Copy>& copies, double squared_content) const;
    double error(const std::vector<Copy>& copies, double share) const;

    const Surface& surface_;
    const MeasuredRows& rows_;
    bool choose_;
};

} // namespace meshbound
