// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/progress/progress_display.h"

#include "app/messages/print.h"

namespace sherd {
namespace {

constexpr auto refresh = std::chrono::milliseconds(100);

}  // namespace

std::string ProgressDisplay::line(const ProgressMeter& meter) const {
    return progress_line(meter.status(), lines.columns(), name_columns);
}

void ProgressDisplay::show(std::span<ProgressMeter* const> running, bool at_once) {
    if (!lines.possible()) return print_tenths(running);
    const auto now = std::chrono::steady_clock::now();
    if (!at_once && now - last_shown < refresh) return;
    last_shown = now;
    std::vector<std::string> texts;
    for (const ProgressMeter* meter : running) texts.push_back(line(*meter));
    lines.draw(std::move(texts));
}

void ProgressDisplay::begin() {
    if (lines.possible() || timer) return;
    records = {"sherd: nothing is done yet"};
    begun = std::chrono::steady_clock::now();
    timer.emplace(idle, [this] { repeat(); });
}

void ProgressDisplay::print_tenths(std::span<ProgressMeter* const> running) {
    begin();
    const std::lock_guard lock(mutex);
    records.clear();
    for (ProgressMeter* meter : running) {
        records.push_back(progress_record(meter->status()));
        if (!meter->has_new_tenth()) continue;
        print_message("{}\n", records.back());
        timer->restart();
    }
}

void ProgressDisplay::repeat() {
    const std::chrono::duration<double> since = std::chrono::steady_clock::now() - begun;
    const std::lock_guard lock(mutex);
    for (const std::string& record : records)
        print_message("{}, after {}\n", record, clock_text(since.count()));
}

void ProgressDisplay::leave(const ProgressMeter& ended) {
    if (!lines.possible()) {
        const std::lock_guard lock(mutex);
        records.clear();
        return;
    }
    lines.clear();
    lines.draw({line(ended)});
    lines.leave();
}

void ProgressDisplay::clear_for_output() {
    lines.clear();
    last_shown = {};
}

}  // namespace sherd
