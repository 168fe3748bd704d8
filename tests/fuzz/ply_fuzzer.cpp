// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/fuzz/mesh_input.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace sherd::test;
    const auto file = fuzz_folder().write("a.ply", text_of(data, size));
    fuzz_mesh(file);
    read_or_refuse([&] { sherd::read_vertex_property(file, "x"); });
    return 0;
}
