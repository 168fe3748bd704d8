// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace sherd {

/// Some words beside a bar.
struct ProgressPart {
    std::string text;
    int rank;  ///< the highest is left out first where there is no room for all
};

/// What a line says of a piece of work.
struct ProgressStatus {
    std::string name;  ///< before the bar; may be empty
    double done = 0;   ///< 0 to 1
    std::vector<ProgressPart> parts;
};

/// A line with a bar, shorter than a terminal of so many columns: it never wraps. name_columns: to which
/// names of several lines are filled up.
std::string progress_line(const ProgressStatus& status, std::size_t columns, std::size_t name_columns = 0);

/// All of it without a bar, for a file: `name:  10%  step 12  ...`.
std::string progress_record(const ProgressStatus& status);

/// Minutes and seconds, from an hour on hours too: `1:02:03`. The longest is 999 hours.
std::string clock_text(double seconds);

}  // namespace sherd
