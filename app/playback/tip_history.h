// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "app/recording/recording.h"

namespace sherd {

/// Crack tips of a run, step by step.
class TipHistory {
  public:
    explicit TipHistory(const Recording& recording);

    bool empty() const { return records.empty(); }
    /// Returns the tips after the last step that ended before a moment. step: of the frame at or before the
    /// moment; time: of the moment, s.
    std::span<const TipRecord> at(std::int64_t step, double time) const;
    double fastest() const;  ///< m/s, largest speed of a tip

  private:
    std::vector<TipRecord> records;                     ///< ascending by step
    std::vector<std::pair<std::int64_t, double>> ends;  ///< number and end (s) of each step
};

}  // namespace sherd
