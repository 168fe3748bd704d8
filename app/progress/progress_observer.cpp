// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/progress/progress_observer.h"

#include <fmt/format.h>

#include "app/messages/place_text.h"

namespace sherd {
namespace {

constexpr Index most_substeps = 1000;  // most substeps of a step without a warning

}  // namespace

void ProgressObserver::stepped(const StepReport& report, const CrackEvents&) {
    warn_of_substeps(report);
    reporter.update({report.step, report.time, scene.duration, report.step_size,
                     static_cast<std::int64_t>(totals.cracks), report.fragments, totals.halvings,
                     scene.time_unit()});
}

void ProgressObserver::warn_of_substeps(const StepReport& report) {
    if (warned || !report.is_explicit || report.newton_iterations <= most_substeps) return;
    warned = true;
    const FacePlace& face = report.fastest;
    reporter.warn(fmt::format(
        "step {}, at {:.6g} s, took {} substeps, and later steps may, too: {}", report.step, report.time,
        report.newton_iterations,
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
