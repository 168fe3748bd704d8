// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/playback/tip_history.h"

#include <algorithm>

namespace sherd {

TipHistory::TipHistory(const Recording& recording) : records(recording.events().tips) {
    if (records.empty()) return;
    for (const StepReport& step : recording.steps()) ends.emplace_back(step.step, step.time);
}

std::span<const TipRecord> TipHistory::at(std::int64_t step, double time) const {
    const auto later =
        std::ranges::find_if(ends, [&](const auto& end) { return end.first > step && end.second > time; });
    const std::int64_t last = later == ends.begin() ? step : std::prev(later)->first;
    return {std::ranges::lower_bound(records, last, {}, &TipRecord::step),
            std::ranges::upper_bound(records, last, {}, &TipRecord::step)};
}

double TipHistory::fastest() const {
    double fastest = 0;
    for (const TipRecord& record : records) fastest = std::max(fastest, record.speed);
    return fastest;
}

}  // namespace sherd
