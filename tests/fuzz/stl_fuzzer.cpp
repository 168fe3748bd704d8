// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/fuzz/mesh_input.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace sherd::test;
    fuzz_mesh(fuzz_folder().write("a.stl", text_of(data, size)));
    return 0;
}
