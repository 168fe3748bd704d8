// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/progress/progress_observer.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "app/messages/place_text.h"
#include "app/messages/print.h"
#include "meshops/error.h"

namespace sherd {
namespace {

constexpr double pause = 0.1;  // s between two reports, unless another tenth is done

constexpr Index most_parts = 1000;  // a step with more parts of substeps causes a warning

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
    // Every tenth of the run is reported, so that the lines in a file do not depend on the speed of the run.
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
    // A line is shorter than a pipe's buffer, and is therefore written as a whole.
    ssize_t count;
    do count = write(descriptor, line.data(), line.size());
    while (count < 0 && errno == EINTR);
    if (count < 0 && errno == EPIPE) end_without_reader();  // the parent process has been killed
    if (count < 0)
        throw Error(fmt::format("cannot report how far the run is: {}", std::strerror(errno)), Fault::run);
}

void ProgressObserver::stepped(const StepReport& report, const CrackEvents&) {
    warn_of_substeps(report);
    reporter.update({report.step, report.time, scene.duration, report.step_size,
                     static_cast<std::int64_t>(totals.cracks), report.fragments, totals.halvings,
                     scene.time_unit()});
}

void ProgressObserver::warn_of_substeps(const StepReport& report) {
    if (warned || !report.is_explicit || report.newton_iterations <= most_parts) return;
    warned = true;
    const FacePlace& face = report.fastest;
    reporter.warn(fmt::format(
        "step {}, at {:.6g} s, took {} parts of substeps, and later steps may, too: {}", report.step,
        report.time, report.newton_iterations,
        face.sheet < 0
            ? std::string("contact requires them, where something light and stiff meets something fast")
            : fmt::format("the face of sheet.{} at {} at rest requires the shortest; if it is far smaller "
                          "than others, remesh",
                          scene.sheets[face.sheet].name, place_text(face.rest))));
}

void ProgressObserver::ended(const RunEnd& end) {
    // A run may have failed because the reader of the reports has gone.
    if (!end.has_failed()) reporter.finish();
}

}  // namespace sherd
