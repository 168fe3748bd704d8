// SPDX-License-Identifier: GPL-3.0-or-later
#include "fracture/events.h"

namespace sherd {

void set_time(CrackEvents& events, std::int64_t step, double time) {
    visit_kinds([&](auto kind) {
        auto& of_kind = events.*kind;
        for (auto event = of_kind.rbegin(); event != of_kind.rend() && event->step == step; ++event)
            event->time = time;
    });
}

void append(CrackEvents& events, const CrackEvents& later) {
    visit_kinds([&](auto kind) {
        (events.*kind).insert((events.*kind).end(), (later.*kind).begin(), (later.*kind).end());
    });
}

}  // namespace sherd
