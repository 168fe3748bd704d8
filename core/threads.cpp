// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/threads.h"

#include <tbb/blocked_range.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#ifdef SHERD_SANITIZES_THREADS
#include <sanitizer/tsan_interface.h>
#endif

namespace sherd {
namespace {

/// Tells the thread sanitizer, which does not see the synchronisation in TBB, that the parts of a loop run
/// after the code before the loop and before the code after the loop.
class LoopOrder {
  public:
    LoopOrder() { happened(begin); }
    void part_begins() { happens_after(begin); }
    void part_ends() { happened(end); }
    ~LoopOrder() { happens_after(end); }

  private:
#ifdef SHERD_SANITIZES_THREADS
    static void happened(char& what) {
        __tsan_release(&what);
    }
    static void happens_after(char& what) {
        __tsan_acquire(&what);
    }
#else
    static void happened(char&) {}
    static void happens_after(char&) {}
#endif
    char begin = 0, end = 0;
};

}  // namespace

struct Threads::Arena {
    explicit Arena(int count) : arena(count) {}
    tbb::task_arena arena;
};

Threads::Threads(int count)
    : number(std::clamp(count, 1, tbb::info::default_concurrency())),
      arena(number > 1 ? std::make_shared<Arena>(number) : nullptr) {}

void Threads::share(Index parts, const std::function<void(Index)>& part) const {
    if (arena == nullptr || parts < 2) {
        for (Index i = 0; i < parts; ++i) part(i);
        return;
    }
    LoopOrder order;
    arena->arena.execute([&] {
        tbb::parallel_for(
            tbb::blocked_range<Index>(0, parts, 1),
            [&](const tbb::blocked_range<Index>& some) {
                order.part_begins();
                for (Index i = some.begin(); i < some.end(); ++i) part(i);
                order.part_ends();
            },
            tbb::simple_partitioner());
    });
}

}  // namespace sherd
