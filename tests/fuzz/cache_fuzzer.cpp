// SPDX-License-Identifier: GPL-3.0-or-later
// Each input is read as both kinds of point cache, PC2 and MDD, for a mesh of two points.
#include "app/files/point_cache.h"
#include "tests/fuzz/read_input.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace sherd::test;
    for (const char* name : {"a.pc2", "a.mdd"}) {
        const auto file = fuzz_folder().write(name, text_of(data, size));
        read_or_refuse([&] { sherd::read_point_cache(file, 2, "a.obj"); });
    }
    return 0;
}
