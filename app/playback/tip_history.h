// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "app/recording/recording.h"

namespace sherd {

/// Crack tips of a run, by steps.
class TipHistory {
  public:
    explicit TipHistory(const Recording& recording);

    bool empty() const { return records.empty(); }
    /// Returns the records of crack tips at a moment, from the last step that ended at or before it. step:
    /// number of the step of the last frame at or before the moment. time: time of the moment, s.
    std::span<const TipRecord> at(std::int64_t step, double time) const;
    double fastest() const;  ///< m/s, largest speed of a tip

  private:
    std::vector<TipRecord> records;                     ///< ascending by step
    std::vector<std::pair<std::int64_t, double>> ends;  ///< number of each step, and time (s) at its end
};

}  // namespace sherd
