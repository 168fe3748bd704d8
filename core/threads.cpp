// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/threads.h"

#include <tbb/blocked_range.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

namespace sherd {

struct Threads::Arena {
    tbb::task_arena arena;
};

Threads::Threads(int count)
    : number(std::clamp(count, 1, tbb::info::default_concurrency())),
      arena(number > 1 ? std::make_unique<Arena>(Arena{tbb::task_arena(number)}) : nullptr) {}

Threads::~Threads() = default;

void Threads::share(Index parts, const std::function<void(Index)>& part) const {
    if (arena == nullptr || parts < 2) {
        for (Index i = 0; i < parts; ++i) part(i);
        return;
    }
    arena->arena.execute([&] {
        tbb::parallel_for(
            tbb::blocked_range<Index>(0, parts, 1),
            [&](const tbb::blocked_range<Index>& some) {
                for (Index i = some.begin(); i < some.end(); ++i) part(i);
            },
            tbb::simple_partitioner());
    });
}

}  // namespace sherd
