// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <vector>

#include "app/json/json.h"
#include "fracture/events.h"

namespace sherd {

/// What became of the tip of a crack.
struct TipInfo {
    TipRecord first, last;
    double fastest = 0;  ///< m/s
    double largest = 0;  ///< J/m^2, energy released
};

/// Of all tips in a table of them, by number.
std::vector<TipInfo> tips_of(std::span<const TipRecord> records);

/// Appends a table with a row for each tip, of those that bore most at first if there are many, and a word on
/// the others. Nothing is appended without any.
void add_tip_table(std::string& text, std::vector<TipInfo> tips, const std::string& time_unit);

/// The same for scripts.
Json tips_json(std::span<const TipInfo> tips);

}  // namespace sherd
