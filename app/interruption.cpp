// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/interruption.h"

#include <csignal>

namespace sherd {
namespace {

volatile std::sig_atomic_t noted = 0;  // set by a signal handler, which can reach nothing else

void note(int) {
    noted = 1;
}

}  // namespace

void catch_interruption() {
    std::signal(SIGINT, note);
    std::signal(SIGTERM, note);
}

bool interrupted() {
    return noted != 0;
}

}  // namespace sherd
