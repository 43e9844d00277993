#pragma once

#include <ostream>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "meshbound/options.hpp"

/// A way to reduce: every guarantee holds in each of them.
struct Mode {
    std::string name;
    meshbound::Options reduction;

    const meshbound::Options& options() const { return reduction; }
};
inline std::ostream& operator<<(std::ostream& out, const Mode& mode) { return out << mode.name; }

/// The ways that keep the map from the original.
inline std::vector<Mode> tracked_modes() {
    Mode chosen{"Tracked", {}}, unchosen{"TrackedAsLaidOut", {}};
    chosen.reduction.errors = unchosen.reduction.errors = meshbound::ErrorAccounting::tracked;
    unchosen.reduction.optimize_vertex_images = unchosen.reduction.optimize_edge_crossings = false;
    return {chosen, unchosen};
}

inline std::vector<Mode> modes() {
    Mode maximum{"PropagatedMaximum", {}}, introduced{"PropagatedIntroduced", {}};
    maximum.reduction.errors = introduced.reduction.errors = meshbound::ErrorAccounting::propagated;
    maximum.reduction.cost = meshbound::RetriangulationCost::maximum;
    introduced.reduction.cost = meshbound::RetriangulationCost::introduced;
    std::vector<Mode> all = tracked_modes();
    all.insert(all.begin(), {maximum, introduced});
    return all;
}

inline std::string mode_name(const testing::TestParamInfo<Mode>& mode) { return mode.param.name; }

/// A test fixture that runs in every mode: EVERY_MODE(Suite) after its declaration.
class ModeTest : public testing::TestWithParam<Mode> {};

#define EVERY_MODE(Suite) INSTANTIATE_TEST_SUITE_P(EveryMode, Suite, testing::ValuesIn(modes()), mode_name)

/// The same for what only a map tells.
#define EVERY_TRACKED_MODE(Suite)                                                                                      \
    INSTANTIATE_TEST_SUITE_P(EveryTrackedMode, Suite, testing::ValuesIn(tracked_modes()), mode_name)
