// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/machine/threads.h"

#include <algorithm>
#include <thread>

namespace sherd {
namespace {

constexpr unsigned most_threads = 4;  // for all runs together; more threads do not pay off

}  // namespace

int threads_of_run(int most, int runs) {
    if (most > 0) return most;
    const unsigned cores = std::min(std::thread::hardware_concurrency(), most_threads);
    return std::max(1, static_cast<int>(cores) / runs);
}

}  // namespace sherd
