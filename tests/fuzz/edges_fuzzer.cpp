// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/scene/assemble/sheet/edge_list.h"
#include "meshops/read_write/read_mesh.h"
#include "tests/fuzz/read_input.h"

namespace {

/// Square of four triangles around vertex 4, its centre.
sherd::Mesh square() {
    std::vector<std::string> warnings;
    return sherd::read_mesh(
        sherd::test::fuzz_folder().write(
            "a.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv .5 .5 0\nf 1 2 5\nf 2 3 5\nf 3 4 5\nf 4 1 5\n"),
        {}, warnings);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace sherd::test;
    static const sherd::Mesh mesh = square();
    const auto file = fuzz_folder().write("edges.txt", text_of(data, size));
    read_or_refuse([&] { sherd::read_edge_list(file, mesh); });
    return 0;
}
