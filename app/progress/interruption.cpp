// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/progress/interruption.h"

#include <csignal>

namespace sherd {
namespace {

volatile std::sig_atomic_t signalled = 0;  // set by a signal handler, which can reach nothing else

void interrupt(int) {
    signalled = 1;
}

}  // namespace

void watch_for_interruption() {
    std::signal(SIGINT, interrupt);
    std::signal(SIGTERM, interrupt);
}

bool interrupted() {
    return signalled != 0;
}

}  // namespace sherd
