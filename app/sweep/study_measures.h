// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "app/measures/measures.h"

namespace sherd {

/// A number of a run, by the name that it has in studies and in their tables.
struct StudyMeasure {
    std::string name, unit;
    std::string meaning;
    /// None where the run has none, as the time of the first crack of a plate that held.
    std::function<std::optional<double>(const Measures&)> value;
};

/// All but those of single supports and obstacles.
const std::vector<StudyMeasure>& study_measures();

/// What is wrong with a name, with the nearest that is none; empty: nothing. "peak_force.NAME" and
/// "peak_force_time.NAME" are right for any support or obstacle.
std::string measure_mistake(const std::string& name);

/// The name of a support or obstacle behind "peak_force.": "floor" of "obstacle.floor", and "sheet.plate.pin"
/// as it is.
std::string name_in_measures(const std::string& support);

/// The mistake in a measure of a support or obstacle that the scenes do not have, with the nearest name that
/// they have; empty: there is none.
std::string support_mistake(const std::string& measure, const std::set<std::string>& supports);

/// Of a measure's name; empty: a plain number.
std::string measure_unit(const std::string& name);

/// All of a run by name; those that it does not have are left out.
std::map<std::string, double> measure_values(const Measures& measures);

}  // namespace sherd
