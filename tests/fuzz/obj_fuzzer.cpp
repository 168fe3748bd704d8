// SPDX-License-Identifier: GPL-3.0-or-later
// Each input is two files: the text before the first zero byte is the mesh, and the text after it is the file
// of materials, a.mtl.
#include "tests/fuzz/mesh_input.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace sherd::test;
    const std::string text = text_of(data, size);
    const std::size_t end = std::min(text.find('\0'), text.size());
    fuzz_folder().write("a.mtl", text.substr(std::min(end + 1, text.size())));
    fuzz_mesh(fuzz_folder().write("a.obj", text.substr(0, end)));
    return 0;
}
