// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "core/vector.h"

namespace sherd {

/// A team of threads that share the parts of a loop; copies are the same team. Parts do not depend on the
/// number of threads, so that the results of each have the same bits with any number.
class Threads {
  public:
    /// count: largest number of threads, this one included; no more are used than the processor runs at once.
    explicit Threads(int count = 1);

    int count() const { return number; }
    /// Calls part(i) for all i from 0 to before `parts`, in any order and several at a time, and returns when
    /// all are done. An exception in a part ends the loop, and is thrown again.
    void share(Index parts, const std::function<void(Index)>& part) const;
    /// Calls range(begin, end) for ranges of `length` that together are 0 to before `size`.
    template <class Range>
    void share_ranges(Index size, Index length, const Range& range) const {
        share((size + length - 1) / length,
              [&](Index part) { range(part * length, std::min(size, (part + 1) * length)); });
    }

    /// Calls find(i, local) for i from 0 to before `size`, in any order and several at a time, with a `Local`
    /// that may hold another element's data, and take(first, locals) in this thread, in order, for those of
    /// each lot.
    template <class Local, class Find, class Take>
    void share_lots(std::size_t size, const Find& find, const Take& take) const;

  private:
    struct Arena;
    int number;
    std::shared_ptr<Arena> arena;  ///< null for one thread
};

template <class Local, class Find, class Take>
void Threads::share_lots(std::size_t size, const Find& find, const Take& take) const {
    // Lots fit into a cache, and are large enough to share; a single thread takes each element at once.
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
