// SPDX-License-Identifier: GPL-3.0-or-later
#include "fracture/events.h"

namespace sherd {

void append(CrackEvents& events, const CrackEvents& later) {
    const auto add = [](auto& to, const auto& from) { to.insert(to.end(), from.begin(), from.end()); };
    add(events.failures, later.failures);
    add(events.openings, later.openings);
    add(events.splits, later.splits);
    add(events.births, later.births);
}

}  // namespace sherd
