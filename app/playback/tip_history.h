// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "app/recording/recording.h"

namespace sherd {

/// The tips of the cracks of a run, step by step.
class TipHistory {
  public:
    explicit TipHistory(const Recording& recording);

    bool empty() const { return records.empty(); }
    /// Of the last step that had ended at a moment: that of a frame, or one between it and the next.
    std::span<const TipRecord> at(std::int64_t step, double time) const;
    double fastest() const;  ///< m/s

  private:
    std::vector<TipRecord> records;                     ///< by step
    std::vector<std::pair<std::int64_t, double>> ends;  ///< each step, and when it ended
};

}  // namespace sherd
