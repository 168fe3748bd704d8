// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/progress.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>

namespace sherd {
namespace {

constexpr int bar_width = 24;
constexpr auto refresh = std::chrono::milliseconds(100);

std::string clock(double seconds) {
    const long whole = std::max(0L, static_cast<long>(seconds + 0.5));
    return whole < 3600 ? fmt::format("{}:{:02}", whole / 60, whole % 60)
                        : fmt::format("{}:{:02}:{:02}", whole / 3600, whole / 60 % 60, whole % 60);
}

}  // namespace

Progress::Progress(double total)
    : total(total),
      terminal(isatty(STDERR_FILENO)),
      start(std::chrono::steady_clock::now()),
      last_shown(start) {}

double Progress::wall_seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

void Progress::show(double amount, const std::string& before, const std::string& after) {
    const double done = std::min(1.0, amount / total);
    const std::string status =
        fmt::format("{}  ETA {}{}{}", before, clock(wall_seconds() * (1 - done) / done),
                    after.empty() ? "" : "  ", after);
    if (terminal) {
        const auto now = std::chrono::steady_clock::now();
        if (now - last_shown < refresh && done < 1) return;
        last_shown = now;
        const int filled = static_cast<int>(done * bar_width);
        fmt::print(stderr, "\r\x1b[K[{:#>{}}{:.>{}}] {}", "", filled, "", bar_width - filled, status);
        std::fflush(stderr);
    } else if (static_cast<int>(done * 10 + 1e-9) > tenths) {
        tenths = static_cast<int>(done * 10 + 1e-9);
        fmt::print(stderr, "{:3}%  {}\n", tenths * 10, status);
    }
}

void Progress::update(const StepReport& report, std::size_t cracks, std::int64_t halvings) {
    const std::string halved =
        halvings == 0 ? "" : fmt::format("  halved {} times, now {:.3g} s", halvings, report.step_size);
    show(report.time, fmt::format("step {}  {:.4g} of {:.4g} s", report.step, report.time, total),
         fmt::format("cracks {}  fragments {}{}", cracks, report.fragments, halved));
}

void Progress::finish() {
    if (terminal) fmt::print(stderr, "\n");
}

}  // namespace sherd
