// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/progress/progress.h"

#include <array>
#include <utility>

namespace sherd {

void Progress::show(double amount, ProgressText text) {
    meter.update(amount, std::move(text));
    display.show(std::array{&meter});
    shown = true;
}

void Progress::finish() {
    if (!std::exchange(shown, false)) return;
    meter.end();
    display.leave(meter);
}

}  // namespace sherd
