#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "errors/accounting.hpp"
#include "surface/hole.hpp"
#include "retriangulation/layout.hpp"
#include "retriangulation/legality.hpp"
#include "retriangulation/original_normals.hpp"
#include "self_intersection/piercing.hpp"
#include "retriangulation/retriangulation.hpp"
#include "metric/rows.hpp"
#include "surface/surface.hpp"

namespace meshbound {

/// Why a candidate is still there.
enum class Refusal : std::uint8_t {
    none,     ///< it was removed, or not looked at yet
    ring,     ///< too large a ring
    topology, ///< §3.2.3
    fold,     ///< no retriangulation without a fold
    piercing, ///< what stays within the bounds would pierce another lobe
    bound,    ///< a bound would break
};

/// One is kept for every vertex.
struct Verdict {
    Refusal refusal = Refusal::none;
    bool stale = false;         ///< the star has changed since
    std::uint16_t variable = 0; ///< with Refusal::bound: the one in which it would break (see validate for how many) …
    float squared_ratio = 0;    ///< … and at least this squared ratio to the bound, or nearly, would have resulted
};

/// What of the surface's shape is looked at besides the hole (§3.2.3).
struct Guards {
    const OriginalNormals& normals;
    Piercing* piercing = nullptr; ///< where piercing is refused
};

/// One removal, start to end (§3.1): star, layout, retriangulation, mapping, measurement, and acceptance or nothing.
///
/// A candidate on a curve of the input has a copy on every sheet that meets there (see Surface). Their stars are the *parts*
/// of one removal: all of them go, with one closing edge each between the same two sites and all that was on the curve at the
/// same share of it, or none does. So the map stays continuous across the curve, and no crack opens.
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
    std::size_t work() const;

    /// Calls `visit(vertex)` for the ring vertices of the last attempt's holes: after a removal they are what changed.
    template <class Visit>
    void for_each_ring_vertex(const Visit& visit) const {
        for (std::size_t n = 0; n < count_; ++n)
            for (const std::uint32_t vertex : parts_[n]->hole.ring) visit(vertex);
    }

private:
    /// One star with what fills its hole.
    struct Part {
        Part(Accounting& accounting, const Guards& guards)
            : removals(accounting.removals()), legality(guards.normals, removals->minds_turns()) {}

        std::unique_ptr<RemovalAccounting> removals;
        Hole hole;
        Legality legality;
        Retriangulator retriangulator;
        Retriangulation retriangulation;
    };
    /// A retriangulation that was looked at.
    struct Trial {
        Measured measured;
        bool pierces = false;

        bool accepted(double squared_limit) const { return measured.squared_ratio <= squared_limit && !pierces; }
    };
    void open(std::uint32_t vertex);
    bool enter();
    bool has_large_ring() const;
    bool would_change_slits() const;
    bool triangulate();
    Trial try_part(Part& part, double squared_limit, Effort effort);
    Trial try_out(Part& part, double squared_limit);
    Trial try_fans(Part& part, double squared_limit, Trial refused);
    bool parts_meet() const;
    bool pierces() const;
    void take();

    Surface& surface_;
    const Rows& rows_;
    Accounting& accounting_;
    Guards guards_;
    std::vector<std::unique_ptr<Part>> parts_;
    std::size_t count_ = 0; // of the parts, those of this attempt
    std::vector<RemovalAccounting*> joined_;
};

} // namespace meshbound
