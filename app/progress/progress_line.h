// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace sherd {

/// A text beside a bar.
struct ProgressPart {
    std::string text;
    int rank;  ///< parts of the highest rank are left out first if the line is too long
};

/// Content of the line of a task.
struct ProgressStatus {
    std::string name;  ///< before the bar; may be empty
    double done = 0;   ///< 0 to 1
    std::vector<ProgressPart> parts;
};

/// Returns a line with a bar, shorter than a terminal of so many columns, so that it never wraps.
/// name_columns: width to which names are filled up.
std::string progress_line(const ProgressStatus& status, std::size_t columns, std::size_t name_columns = 0);

/// Returns the line without a bar, for a file: `name:  10%  step 12  ...`.
std::string progress_record(const ProgressStatus& status);

/// Returns minutes and seconds, from an hour on hours too: `1:02:03`. Longer times are cut to 999 hours.
std::string clock_text(double seconds);

}  // namespace sherd
