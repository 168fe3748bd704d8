// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/progress/progress_display.h"

#include <fmt/format.h>

namespace sherd {
namespace {

constexpr auto refresh = std::chrono::milliseconds(100);

}  // namespace

std::string ProgressDisplay::line(const ProgressMeter& meter) const {
    return progress_line(meter.status(), lines.columns(), name_columns);
}

void ProgressDisplay::show(std::span<ProgressMeter* const> running, bool at_once) {
    if (!lines.possible()) {
        for (ProgressMeter* meter : running)
            if (meter->has_new_tenth()) fmt::print(stderr, "{}\n", progress_record(meter->status()));
        return;
    }
    const auto now = std::chrono::steady_clock::now();
    if (!at_once && now - last_shown < refresh) return;
    last_shown = now;
    std::vector<std::string> texts;
    for (const ProgressMeter* meter : running) texts.push_back(line(*meter));
    lines.draw(std::move(texts));
}

void ProgressDisplay::leave(const ProgressMeter& ended) {
    lines.clear();
    lines.draw({line(ended)});
    lines.leave();
}

void ProgressDisplay::make_way() {
    lines.clear();
    last_shown = {};
}

}  // namespace sherd
