// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/time_table.h"

#include <fmt/format.h>

namespace sherd {

std::string time_table(const TimeSpent& spent, double recording, double whole) {
    std::string table = fmt::format("{:<22}{:>10}{:>10}\n", "time spent on", "seconds", "share");
    const auto row = [&](const char* name, double seconds) {
        table += fmt::format("{:<22}{:>10.2f}{:>8.1f} %\n", name, seconds, 100 * seconds / whole);
    };
    const double solver = spent.on(Task::analysis) + spent.on(Task::factorization) + spent.on(Task::solution);
    const double known = spent.on(Task::elasticity) + spent.on(Task::contact) + spent.on(Task::loads) +
                         solver + spent.on(Task::breaking) + recording;
    row("elastic energies", spent.on(Task::elasticity));
    row("linear solver", solver);
    row("  analysis", spent.on(Task::analysis));
    row("  factorization", spent.on(Task::factorization));
    row("  solution", spent.on(Task::solution));
    row("contact", spent.on(Task::contact));
    row("loads, wind, damping", spent.on(Task::loads));
    row("breaking", spent.on(Task::breaking));
    row("recording", recording);
    row("rest", whole - known);
    return table;
}

}  // namespace sherd
