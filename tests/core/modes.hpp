#pragma once

#include <ostream>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "meshbound/options.hpp"

/// A way to reduce: every promise holds in each of them.
struct Mode {
    std::string name;
    meshbound::Options reduction;

    const meshbound::Options& options() const { return reduction; }
    bool tracked() const { return reduction.errors == meshbound::Errors::tracked; }
};
inline std::ostream& operator<<(std::ostream& out, const Mode& mode) { return out << mode.name; }

inline std::vector<Mode> modes() {
    using meshbound::Cost;
    using meshbound::Errors;
    Mode maximum{"PropagatedMaximum", {}}, introduced{"PropagatedIntroduced", {}}, tracked{"Tracked", {}};
    maximum.reduction.errors = introduced.reduction.errors = Errors::propagated;
    maximum.reduction.cost = Cost::maximum;
    introduced.reduction.cost = Cost::introduced;
    tracked.reduction.errors = Errors::tracked;
    Mode unchosen{"TrackedAsLaidOut", tracked.reduction};
    unchosen.reduction.choose_places = unchosen.reduction.choose_crossings = false;
    return {maximum, introduced, tracked, unchosen};
}

/// A test fixture that runs in every mode: EVERY_MODE(Suite) after its declaration.
class ModeTest : public testing::TestWithParam<Mode> {};

#define EVERY_MODE(Suite)                                                                                              \
    INSTANTIATE_TEST_SUITE_P(EveryMode, Suite, testing::ValuesIn(modes()),                                             \
                             [](const testing::TestParamInfo<Mode>& mode) { return mode.param.name; })
