#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "accounting.hpp"
#include "hole.hpp"
#include "layout.hpp"
#include "legality.hpp"
#include "original_normals.hpp"
#include "piercing.hpp"
#include "retriangulation.hpp"
#include "rows.hpp"
#include "surface.hpp"

namespace meshbound {

/// Why a candidate is still there.
enum class Refusal : std::uint8_t {
    none,     ///< it was removed, or not looked at yet
    topology, ///< §3.2.3, or too large a ring
    fold,     ///< no retriangulation without a fold
    piercing, ///< what stays within the bounds would pierce another lobe
    bound,    ///< a bound would break
};

struct Verdict {
    Refusal refusal = Refusal::none;
    double squared_ratio = 0; ///< with Refusal::bound: at least this squared ratio to the bound would have resulted
    std::size_t variable = 0; ///< and in this variable
};

/// What of the surface's shape is looked at besides the hole (§3.2.3).
struct Guards {
    const OriginalNormals& normals;
    Piercing* piercing = nullptr; ///< where piercing is refused
};

/// One removal, start to end (§3.1): star, layout, retriangulation, mapping, measurement, and acceptance or nothing.
class Removal {
public:
    Removal(Surface& surface, const Rows& rows, Accounting& accounting, const Guards& guards);

    /// How hard to look for a retriangulation that stays within the limit.
    enum class Effort {
        best,     ///< the cheapest one, or none
        thorough, ///< if the cheapest one fails, the fan around each ring vertex too
    };

    /// Removes the candidate if every error stays within the limit (squared ratio), else leaves everything as it was.
    Verdict attempt(std::uint32_t candidate, double squared_limit, Effort effort);

    /// What the last attempt cost in time, in units of a small star.
    std::size_t work() const { return accounting_->work(); }

    /// The hole of the last attempt: after a removal its ring is what changed.
    const Hole& hole() const { return hole_; }

private:
    /// A retriangulation that was looked at.
    struct Trial {
        Measured measured;
        bool pierces = false;

        bool accepted(double squared_limit) const { return measured.squared_ratio <= squared_limit && !pierces; }
    };
    Trial try_out(double squared_limit);
    Trial try_fans(double squared_limit, Trial refused);
    void take();

    Surface& surface_;
    const Rows& rows_;
    std::unique_ptr<RemovalAccounting> accounting_;
    Piercing* piercing_;
    Hole hole_;
    Legality legality_;
    Retriangulator retriangulator_;
    Retriangulation retriangulation_;
};

} // namespace meshbound
