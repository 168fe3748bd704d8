// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/progress/run_reporter.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "app/messages/print.h"
#include "meshops/error.h"

namespace sherd {
namespace {

constexpr double pause = 0.1;  // s between two reports, unless a tenth is done

}  // namespace

RunReporter::RunReporter(double duration, double begun, int descriptor)
    : shown(duration, begun), sent(duration), descriptor(descriptor) {
    if (descriptor >= 0 && fcntl(descriptor, F_GETFD) < 0)
        throw Error(fmt::format("--progress-to {}: this descriptor is not open", descriptor));
    if (descriptor < 0) shown.begin();
}

void RunReporter::update(const RunProgress& progress) {
    if (descriptor < 0) return shown.show(progress.time, progress_text(progress));
    last = progress;
    sent.update(progress.time, {});
    // Every tenth is reported, so that the lines in a file do not depend on the speed of a run.
    if (!sent.has_new_tenth() && wall_seconds() - last_sent < pause) return;
    last_sent = wall_seconds();
    send();
}

void RunReporter::warn(const std::string& words) {
    shown.clear_for_output();
    print_warnings({words});
}

void RunReporter::finish() {
    shown.finish();
    if (descriptor >= 0) send();
}

void RunReporter::send() const {
    const std::string line = to_line(last);
    // A line is shorter than a pipe's buffer, and so written whole.
    ssize_t count;
    do count = write(descriptor, line.data(), line.size());
    while (count < 0 && errno == EINTR);
    if (count < 0 && errno == EPIPE) end_without_reader();  // the parent process has been killed
    if (count < 0)
        throw Error(fmt::format("cannot report how far the run is: {}", std::strerror(errno)), Fault::run);
}

}  // namespace sherd
