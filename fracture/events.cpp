// SPDX-License-Identifier: GPL-3.0-or-later
#include "fracture/events.h"

namespace sherd {

void set_time(CrackEvents& events, std::int64_t step, double time) {
    const auto set = [&](auto& of_kind) {
        for (auto event = of_kind.rbegin(); event != of_kind.rend() && event->step == step; ++event)
            event->time = time;
    };
    set(events.failures);
    set(events.openings);
    set(events.splits);
    set(events.births);
}

void append(CrackEvents& events, const CrackEvents& later) {
    const auto add = [](auto& to, const auto& from) { to.insert(to.end(), from.begin(), from.end()); };
    add(events.failures, later.failures);
    add(events.openings, later.openings);
    add(events.splits, later.splits);
    add(events.births, later.births);
}

}  // namespace sherd
