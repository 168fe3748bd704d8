// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/progress/progress_meter.h"

#include <algorithm>
#include <utility>

namespace sherd {

ProgressMeter::ProgressMeter(double total, std::string name, double begun)
    : total(total), begun(begun), start(std::chrono::steady_clock::now()) {
    current.name = std::move(name);
}

double ProgressMeter::wall_seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

void ProgressMeter::set_parts(const std::string& clock) {
    current.parts = text.before;
    if (!clock.empty()) current.parts.push_back({clock, 0});
    current.parts.insert(current.parts.end(), text.after.begin(), text.after.end());
}

void ProgressMeter::update(double amount, ProgressText text_) {
    const double done = current.done = std::clamp(amount / total, 0., 1.);
    text = std::move(text_);
    const double since = done - begun / total;
    set_parts(since <= 0 ? "" : "ETA " + clock_text(wall_seconds() * (1 - done) / since));
}

void ProgressMeter::end(const std::string& how) {
    set_parts(how + " " + clock_text(wall_seconds()));
}

bool ProgressMeter::has_new_tenth() {
    const int now = static_cast<int>(current.done * 10 + 1e-9);
    return now > std::exchange(tenths, std::max(tenths, now));
}

}  // namespace sherd
