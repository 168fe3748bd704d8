// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <vector>

#include "app/json/json.h"
#include "fracture/record/events.h"

namespace sherd {

/// History of a crack tip.
struct TipInfo {
    TipRecord first, last;
    double fastest = 0;  ///< m/s
    double largest = 0;  ///< J/m^2, energy released
};

/// Histories of all tips in a list of records, by number.
std::vector<TipInfo> tips_of(std::span<const TipRecord> records);

/// Appends a table with a row for each tip; if there are many, only for those with the largest release rate,
/// and the number of the others. Appends nothing without tips.
void add_tip_table(std::string& text, std::vector<TipInfo> tips, const std::string& time_unit);

/// The histories as a JSON array.
Json tips_json(std::span<const TipInfo> tips);

}  // namespace sherd
