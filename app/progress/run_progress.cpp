// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/progress/run_progress.h"

#include <fmt/format.h>

#include <sstream>

#include "app/messages/counted.h"
#include "app/messages/time_text.h"

namespace sherd {

ProgressText progress_text(const RunProgress& progress) {
    ProgressText text{
        {{fmt::format("step {}", progress.step), 4},
         {time_text(fmt::format("{:.4g} of {:.4g}", progress.time, progress.duration), progress.unit), 1}},
        {{fmt::format("cracks {}", progress.cracks), 3},
         {fmt::format("fragments {}", progress.fragments), 2}}};
    if (progress.halvings > 0)
        text.after.push_back({fmt::format("halved {}, now {:.3g}{}", counted(progress.halvings, "time"),
                                          progress.step_size, progress.unit == "s" ? " s" : ""),
                              5});
    return text;
}

std::string to_line(const RunProgress& p) {
    return fmt::format("{} {} {} {} {} {} {} {}\n", p.step, p.time, p.duration, p.step_size, p.cracks,
                       p.fragments, p.halvings, p.unit);
}

std::optional<RunProgress> run_progress(const std::string& line) {
    std::istringstream stream(line);
    RunProgress p;
    stream >> p.step >> p.time >> p.duration >> p.step_size >> p.cracks >> p.fragments >> p.halvings >>
        p.unit;
    if (!stream) return std::nullopt;
    return p;
}

}  // namespace sherd
