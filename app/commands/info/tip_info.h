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
    TipRecord first, last;  ///< first and last record of the tip
    double fastest = 0;     ///< m/s, largest speed
    double largest = 0;     ///< J/m^2, largest release rate
};

/// Histories of all tips in a list of records, ordered by the number of the tip.
std::vector<TipInfo> tips_of(std::span<const TipRecord> records);

/// Appends a table with a row for each tip. If there are many tips, the table has only the tips with the
/// largest release rates, and the number of the other tips. Appends nothing if there are no tips.
void add_tip_table(std::string& text, std::vector<TipInfo> tips, const std::string& time_unit);

/// The histories as a JSON array.
Json tips_json(std::span<const TipInfo> tips);

}  // namespace sherd
