// Lists of crossings, against plain vectors that are changed in the same way.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <set>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "errors/tracked/crossings.hpp"
#include "meshes/random.hpp"

namespace {

using namespace meshbound;

Crossing crossing(std::uint32_t original, std::uint32_t current, double s) {
    return {s, 1 - s, original, current, no_index, no_index, no_index, s < 0.5};
}

/// The crossings of an original edge as the list has them, which must read the same backwards.
std::vector<double> shares(const Crossings& crossings, std::uint32_t original) {
    std::vector<double> forward, backward;
    for (std::uint32_t id = crossings.first(original); id != no_index; id = crossings[id].next)
        forward.push_back(crossings[id].s);
    for (std::uint32_t id = crossings.last(original); id != no_index; id = crossings[id].previous)
        backward.push_back(crossings[id].s);
    std::reverse(backward.begin(), backward.end());
    EXPECT_EQ(forward, backward);
    return forward;
}

std::multiset<double> on(const Crossings& crossings, std::uint32_t current) {
    std::multiset<double> found;
    for (std::uint32_t id = crossings.on(current); id != no_index; id = crossings[id].sibling)
        found.insert(crossings[id].s);
    return found;
}

TEST(Crossings, AreListedAlongOriginalEdgesAndGatheredOnCurrentOnes) {
    constexpr std::uint32_t edges = 40;
    Crossings crossings(edges);
    Crossings::FreeList free_list(crossings);
    meshes::Random random(5);
    std::vector<std::vector<double>> along(edges);
    std::vector<std::multiset<double>> gathered(edges);
    for (std::uint32_t original = 0; original < edges; ++original) {
        std::uint32_t before = no_index;
        const std::size_t count = random.below(600); // more than a free list gets at a time
        for (std::size_t i = 0; i < count; ++i) {
            const auto current = static_cast<std::uint32_t>(random.below(edges));
            const double s = static_cast<double>(i / 2) / 600; // some at one place
            const std::uint32_t id = crossings.add(crossing(original, current, s), free_list);
            crossings.link(original, before, id);
            before = id;
            along[original].push_back(s);
            gathered[current].insert(s);
        }
        crossings.link(original, before, no_index);
    }
    for (std::uint32_t edge = 0; edge < edges; ++edge) {
        EXPECT_EQ(shares(crossings, edge), along[edge]);
        EXPECT_EQ(on(crossings, edge), gathered[edge]);
    }
}

TEST(Crossings, ReleasedSlotsAreUsedAgainAndOthersStay) {
    Crossings crossings(3);
    Crossings::FreeList free_list(crossings);
    std::set<std::uint32_t> released;
    for (int i = 0; i < 10; ++i) released.insert(crossings.add(crossing(0, 0, i / 10.0), free_list));
    const std::uint32_t kept = crossings.add(crossing(1, 1, 0.25), free_list);
    crossings.clear(0, free_list);
    EXPECT_EQ(crossings.on(0), no_index);
    EXPECT_EQ(on(crossings, 1), (std::multiset<double>{0.25}));
    std::set<std::uint32_t> again;
    for (int i = 0; i < 10; ++i) again.insert(crossings.add(crossing(2, 2, i / 20.0), free_list));
    EXPECT_EQ(again, released);
    EXPECT_EQ(crossings[kept].s, 0.25);
    EXPECT_EQ(on(crossings, 2).size(), 10U);
}

TEST(Crossings, WhatAThreadGivesBackAnotherOneGets) {
    Crossings crossings(2);
    std::set<std::uint32_t> given_back, taken;
    {
        Crossings::FreeList free_list(crossings);
        for (int i = 0; i < 300; ++i) given_back.insert(crossings.add(crossing(0, 0, 0.5), free_list));
        crossings.clear(0, free_list);
    }
    Crossings::FreeList free_list(crossings);
    // Of 512 slots that were handed out, all are given back: those that were never used, too.
    for (int i = 0; i < 512; ++i) taken.insert(crossings.add(crossing(1, 1, 0.5), free_list));
    EXPECT_EQ(taken.size(), 512U);
    EXPECT_TRUE(std::includes(taken.begin(), taken.end(), given_back.begin(), given_back.end()));
    EXPECT_EQ(*taken.rbegin(), 511U);
}

TEST(Crossings, SeveralThreadsNeverGetOneSlotTwice) {
    constexpr std::uint32_t threads = 4, rounds = 20, each = 300;
    Crossings crossings(threads);
    std::vector<std::thread> running;
    for (std::uint32_t thread = 0; thread < threads; ++thread)
        running.emplace_back([&crossings, thread] {
            Crossings::FreeList free_list(crossings);
            for (std::uint32_t round = 0; round < rounds; ++round) {
                crossings.clear(thread, free_list);
                for (std::uint32_t i = 0; i < each; ++i)
                    crossings.add(crossing(thread, thread, i / double(each)), free_list);
            }
        });
    for (std::thread& thread : running) thread.join();
    std::set<std::uint32_t> used;
    for (std::uint32_t thread = 0; thread < threads; ++thread) {
        EXPECT_EQ(on(crossings, thread).size(), each);
        for (std::uint32_t id = crossings.on(thread); id != no_index; id = crossings[id].sibling) {
            EXPECT_TRUE(used.insert(id).second);
            EXPECT_EQ(crossings[id].original, thread);
        }
    }
}

} // namespace
