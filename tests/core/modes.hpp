#pragma once

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "meshbound/options.hpp"

/// The ways to reduce: every promise holds in each of them.
struct Mode {
    std::string name;
    meshbound::Errors errors;
    meshbound::Cost cost;

    meshbound::Options options() const {
        meshbound::Options options;
        options.errors = errors;
        options.cost = cost;
        return options;
    }
};
inline std::ostream& operator<<(std::ostream& out, const Mode& mode) { return out << mode.name; }

inline std::vector<Mode> modes() {
    using meshbound::Cost;
    using meshbound::Errors;
    return {
        {"PropagatedMaximum", Errors::propagated, Cost::maximum},
        {"PropagatedIntroduced", Errors::propagated, Cost::introduced},
    };
}

/// A test fixture that runs in every mode: EVERY_MODE(Suite) after its declaration.
class ModeTest : public testing::TestWithParam<Mode> {};

#define EVERY_MODE(Suite)                                                                                              \
    INSTANTIATE_TEST_SUITE_P(EveryMode, Suite, testing::ValuesIn(modes()),                                             \
                             [](const testing::TestParamInfo<Mode>& mode) { return mode.param.name; })
