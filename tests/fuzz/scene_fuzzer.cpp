// SPDX-License-Identifier: GPL-3.0-or-later
// Each input is read as a scene. If its first line is a comment, such as "#small", the scene is also read
// with the variant of this name.
#include "app/scene/read/scene.h"
#include "tests/fuzz/read_input.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace sherd::test;
    const std::string text = text_of(data, size);
    read_or_refuse([&] { sherd::parse_scene(text, "a.toml"); });
    if (text.starts_with('#')) {
        const std::string variant = text.substr(1, text.find('\n') - 1);
        read_or_refuse([&] { sherd::parse_scene(text, "a.toml", {.variant = variant}); });
    }
    return 0;
}
