// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/sweep/run/unlocked_output.h"

#include <chrono>
#include <thread>

#include "app/files/disk/output_lock.h"
#include "meshops/error.h"

namespace sherd {

void wait_until_unlocked(const std::filesystem::path& output) {
    constexpr auto pause = std::chrono::milliseconds(50);
    constexpr auto patience = std::chrono::minutes(1);
    const auto start = std::chrono::steady_clock::now();
    for (;;) try {
            const OutputLock lock(output);
            return;
        } catch (const Error&) {
            if (std::chrono::steady_clock::now() - start > patience) throw;
            std::this_thread::sleep_for(pause);
        }
}

}  // namespace sherd
