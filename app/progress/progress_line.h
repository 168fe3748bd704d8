// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace sherd {

/// A text beside a progress bar.
struct ProgressPart {
    std::string text;
    int rank;  ///< parts of the highest rank are left out first if the line is too long
};

/// Content of the progress line of a task.
struct ProgressStatus {
    std::string name;  ///< precedes the bar; may be empty
    double done = 0;   ///< share of the work that is done, 0 to 1
    std::vector<ProgressPart> parts;
};

/// Returns a line with a bar. The line is shorter than `columns`, the width of the terminal, so that it never
/// wraps. name_columns: width to which names are filled up with blanks.
std::string progress_line(const ProgressStatus& status, std::size_t columns, std::size_t name_columns = 0);

/// Returns a line without a bar, for a file: `name:  10%  step 12  ...`.
std::string progress_record(const ProgressStatus& status);

/// Returns a time as minutes and seconds, or from one hour on as hours, minutes and seconds: `1:02:03`. Times
/// above 999 hours are shown as 999 hours.
std::string clock_text(double seconds);

}  // namespace sherd
