// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "core/vector.h"

namespace sherd {

/// A team of threads that share the parts of a loop; copies of this object refer to the same team. Loops are
/// divided into the same parts with any number of threads, so that the results of a part always have the same
/// bits.
class Threads {
  public:
    /// count: largest number of threads, this one included; no more are used than the processor runs at once.
    explicit Threads(int count = 1);

    int count() const { return number; }
    /// Calls part(i) for all i from 0 to before `parts`, in any order and several at a time, and returns when
    /// all parts are done. An exception in a part ends the loop, and is thrown again.
    void share(Index parts, const std::function<void(Index)>& part) const;
    /// Calls range(begin, end), in any order and several at a time, for ranges of `length` numbers (the last
    /// one may be shorter) that together cover the numbers from 0 to before `size`.
    template <class Range>
    void share_ranges(Index size, Index length, const Range& range) const {
        share((size + length - 1) / length,
              [&](Index part) { range(part * length, std::min(size, (part + 1) * length)); });
    }

    /// Divides the numbers from 0 to before `size` into lots, and processes the lots in order. For each lot
    /// it first calls find(i, local) for all i in the lot, in any order and several at a time, with a `Local`
    /// that may still hold another number's data. Then it calls take(first, locals) in this thread, with the
    /// lot's first number and its `Local`s.
    template <class Local, class Find, class Take>
    void share_lots(std::size_t size, const Find& find, const Take& take) const;

  private:
    struct Arena;
    int number;
    std::shared_ptr<Arena> arena;  ///< null for one thread
};

template <class Local, class Find, class Take>
void Threads::share_lots(std::size_t size, const Find& find, const Take& take) const {
    // Lots fit into a cache, and are large enough to share; for a single thread each number is a lot.
    const std::size_t of_lot = number == 1 ? 1 : 2048;
    constexpr Index of_part = 64;
    std::vector<Local> locals(std::min(size, of_lot));
    for (std::size_t first = 0; first < size; first += of_lot) {
        const std::span<Local> lot(locals.data(), std::min(of_lot, size - first));
        const auto find_some = [&](Index begin, Index end) {
            for (Index i = begin; i < end; ++i) find(first + i, lot[i]);
        };
        if (number == 1)
            find_some(0, static_cast<Index>(lot.size()));
        else
            share_ranges(static_cast<Index>(lot.size()), of_part, find_some);
        take(first, std::span<const Local>(lot));
    }
}

}  // namespace sherd
