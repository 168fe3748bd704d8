// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <functional>
#include <memory>

#include "core/vector.h"

namespace sherd {

/// A team of threads that share the parts of a loop; copies are the same team. Parts are the same whatever
/// the number of threads, so that what each of them writes for itself has the same bits with any number.
class Threads {
  public:
    /// count: at most, this thread among them, but no more than the processor runs at once.
    explicit Threads(int count = 1);

    int count() const { return number; }
    /// Calls part(i) for all i from 0 to before `parts`, in any order and several at a time, and returns when
    /// all are done. One that throws ends the loop with its exception.
    void share(Index parts, const std::function<void(Index)>& part) const;
    /// Calls range(begin, end) for ranges of `length` that together are 0 to before `size`.
    template <class Range>
    void share_ranges(Index size, Index length, const Range& range) const {
        share((size + length - 1) / length,
              [&](Index part) { range(part * length, std::min(size, (part + 1) * length)); });
    }

  private:
    struct Arena;
    int number;
    std::shared_ptr<Arena> arena;  ///< null for one thread
};

}  // namespace sherd
