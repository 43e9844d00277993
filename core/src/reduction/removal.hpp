#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "errors/error_model.hpp"
#include "metric/rows.hpp"
#include "retriangulation/layout.hpp"
#include "retriangulation/legality.hpp"
#include "retriangulation/original_normals.hpp"
#include "retriangulation/retriangulation.hpp"
#include "self_intersection/self_intersection_check.hpp"
#include "surface/hole.hpp"
#include "surface/surface.hpp"

namespace meshbound {

/// Why a candidate is still there.
enum class Refusal : std::uint8_t {
    none,              ///< it was removed, or not tried yet
    ring,              ///< too large a ring
    topology,          ///< §3.2.3
    fold,              ///< no retriangulation without a fold
    self_intersection, ///< what stays within the bounds would intersect the surface elsewhere
    bound,             ///< a bound would break
};

/// What came of the last attempt to remove a vertex. There is one for every vertex.
struct RemovalOutcome {
    Refusal refusal = Refusal::none;
    bool stale = false;         ///< the star has changed since
    std::uint16_t variable = 0; ///< with Refusal::bound: the one whose bound would break …
    float squared_ratio = 0;    ///< … and a lower bound, nearly, of the squared ratio that would have resulted
};

/// What new triangles are checked against besides the hole (§3.2.3).
struct ValidityChecks {
    const OriginalNormals& normals;
    SelfIntersectionCheck* self_intersection = nullptr; ///< where self-intersection is refused
};

/// One removal, start to end (§3.1): star, layout, retriangulation, mapping, measurement, and acceptance or nothing.
///
/// A candidate on a curve of the input has a vertex on every sheet that meets there (see Surface). Their stars are
/// removed together or not at all, with one closing edge each between the same two coincidence classes, and all that
/// was on the curve at the same share of it. So the map stays continuous across the curve, and no crack opens.
class Removal {
public:
    Removal(Surface& surface, const Rows& rows, ErrorModel& error_model, const ValidityChecks& checks);

    /// How many retriangulations to try.
    enum class Effort {
        best,     ///< the cheapest one, or none
        thorough, ///< if the cheapest one fails, the fan around each ring vertex too
    };

    /// Removes the coincidence class of the candidate if every error stays within the limit (a squared ratio), else
    /// leaves everything as it was.
    RemovalOutcome attempt(std::uint32_t candidate, double squared_limit, Effort effort);

    /// The work of the last attempt, in units of a small star.
    std::size_t work() const;

    /// Calls `visit(vertex)` for the ring vertices of the last attempt's holes: after a removal they are what changed.
    template <class Visit>
    void for_each_ring_vertex(const Visit& visit) const {
        for (std::size_t n = 0; n < count_; ++n)
            for (const std::uint32_t vertex : stars_[n]->hole.ring) visit(vertex);
    }

private:
    /// One star with what fills its hole.
    struct Star {
        Star(ErrorModel& error_model, const ValidityChecks& checks)
            : model(error_model.make_removal_model()), legality(checks.normals, model->limits_normal_deviation()) {}

        std::unique_ptr<RemovalErrorModel> model;
        Hole hole;
        Legality legality;
        Retriangulator retriangulator;
        Retriangulation retriangulation;
    };
    /// A retriangulation that was measured.
    struct Trial {
        RemovalError measured;
        bool self_intersects = false;

        bool accepted(double squared_limit) const {
            return measured.squared_ratio <= squared_limit && !self_intersects;
        }
    };
    void add_star(std::uint32_t vertex);
    bool enter();
    bool has_large_ring() const;
    bool would_change_slits() const;
    bool triangulate();
    Trial try_star(Star& star, double squared_limit, Effort effort);
    Trial try_retriangulation(Star& star, double squared_limit);
    Trial try_fans(Star& star, double squared_limit, Trial refused);
    bool stars_conflict() const;
    bool self_intersects() const;
    void apply();

    Surface& surface_;
    const Rows& rows_;
    ErrorModel& error_model_;
    ValidityChecks checks_;
    std::vector<std::unique_ptr<Star>> stars_;
    std::size_t count_ = 0; // how many of the stars are in use
    std::vector<RemovalErrorModel*> models_;
};

} // namespace meshbound
