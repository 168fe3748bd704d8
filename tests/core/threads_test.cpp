// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/threads.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace sherd {
namespace {

// An element that is lost or taken twice is a wrong force; an element out of order makes a sum that differs
// between machines.
TEST(Threads, LotsAreTakenOnceAndInOrder) {
    for (const int count : {1, 2, 4})
        for (const std::size_t size : {0U, 1U, 2047U, 2048U, 5000U}) {
            std::vector<std::size_t> taken;
            Threads(count).share_lots<std::size_t>(
                size, [](std::size_t i, std::size_t& local) { local = i * i; },
                [&](std::size_t first, std::span<const std::size_t> lot) {
                    EXPECT_EQ(first, taken.size());
                    taken.insert(taken.end(), lot.begin(), lot.end());
                });
            ASSERT_EQ(taken.size(), size) << count;
            for (std::size_t i = 0; i < size; ++i) EXPECT_EQ(taken[i], i * i);
        }
}

TEST(Threads, AnErrorInALotEndsTheLoop) {
    for (const int count : {1, 2})
        EXPECT_THROW(Threads(count).share_lots<int>(
                         3000,
                         [](std::size_t i, int&) {
                             if (i == 2500) throw std::runtime_error("no force");
                         },
                         [](std::size_t first, std::span<const int>) { EXPECT_LE(first, 2500U); }),
                     std::runtime_error);
}

}  // namespace
}  // namespace sherd
