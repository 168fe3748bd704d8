// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <set>
#include <string>
#include <string_view>

#include "app/measures/measures.h"

namespace sherd {

/// Whether a table may have a column of this name besides parameters and keys of a Python file: a fixed
/// column, or a measure.
bool is_study_column(std::string_view name);

/// Returns a message about an unknown measure, with the most similar known name; "" if the name is known.
/// "peak_force.NAME" and "peak_force_time.NAME" are known for any support or obstacle.
std::string measure_error(const std::string& name);

/// Returns the name that a support or obstacle has in measures, behind "peak_force.": "floor" for
/// "obstacle.floor"; "sheet.plate.pin" is unchanged.
std::string name_in_measures(const std::string& support);

/// Returns a message about a measure of a support or obstacle that is not in `supports`, with the most
/// similar name in it; "" if the measure has no such mistake.
std::string support_error(const std::string& measure, const std::set<std::string>& supports);

/// Returns the unit of a measure; "" if it is a plain number.
std::string measure_unit(const std::string& name);

/// Returns the values of all measures of a run by name, without measures that the run does not have.
std::map<std::string, double> measure_values(const Measures& measures);

}  // namespace sherd
