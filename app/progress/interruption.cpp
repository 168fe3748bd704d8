// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/progress/interruption.h"

#include <sys/prctl.h>
#include <unistd.h>

#include <csignal>
#include <string_view>

#include "app/machine/exit_code.h"

namespace sherd {
namespace {

volatile std::sig_atomic_t signalled = 0;  // number of the signal; of this type, as a signal handler sets it

void end_at_once(int signal) {
    constexpr std::string_view words = "\nsherd: interrupted\n";  // after a line that may be incomplete
    [[maybe_unused]] const ssize_t written = write(STDERR_FILENO, words.data(), words.size());
    _exit(signal_base + signal);
}

void interrupt(int signal) {
    if (signalled != 0) end_at_once(signal);
    signalled = signal;
}

}  // namespace

void end_on_interruption() {
    std::signal(SIGINT, end_at_once);
    std::signal(SIGTERM, end_at_once);
}

void watch_for_interruption() {
    std::signal(SIGINT, interrupt);
    std::signal(SIGTERM, interrupt);
}

bool interrupted() {
    return signalled != 0;
}

int interruption_exit_code() {
    return signal_base + signalled;
}

void leave_interruption_to_parent() {
    std::signal(SIGINT, SIG_IGN);
    prctl(PR_SET_PDEATHSIG, SIGTERM);
}

}  // namespace sherd
