// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <set>
#include <string>
#include <string_view>

#include "app/measures/measures.h"

namespace sherd {

/// Whether tables have a column of this name, apart from parameters and keys of Python files.
bool is_study_column(std::string_view name);

/// Error for an unknown measure, with the nearest known name; "" if the name is known. "peak_force.NAME" and
/// "peak_force_time.NAME" are known for any support or obstacle.
std::string measure_error(const std::string& name);

/// Returns the name of a support or obstacle behind "peak_force.": "floor" for "obstacle.floor";
/// "sheet.plate.pin" is unchanged.
std::string name_in_measures(const std::string& support);

/// Error for a measure of a support or obstacle that the scenes do not have, with the nearest name that they
/// have; "" if there is none.
std::string support_error(const std::string& measure, const std::set<std::string>& supports);

/// Unit of a measure; empty: a plain number.
std::string measure_unit(const std::string& name);

/// Returns the values of all measures of a run by name, without those that it does not have.
std::map<std::string, double> measure_values(const Measures& measures);

}  // namespace sherd
