// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "core/time_spent.h"

namespace sherd {

/// A table of what the wall time of a run went into, in s and in shares of the whole. recording: s, on
/// writing it; whole: s, of the run.
std::string time_table(const TimeSpent& spent, double recording, double whole);

}  // namespace sherd
