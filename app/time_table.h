// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "core/time_spent.h"

namespace sherd {

/// Table of the wall time of a run by task, in s and as a share of the whole. recording: s, spent on writing
/// it; whole: s, of the run.
std::string time_table(const TimeSpent& spent, double recording, double whole);

}  // namespace sherd
