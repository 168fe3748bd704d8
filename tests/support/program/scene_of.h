// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/scene/read/scene.h"
#include "tests/support/program/temporary_directory.h"

namespace sherd::test {

/// Reads a scene from a file with this text.
inline Scene scene_of(const std::string& text, const SceneChoice& choice = {}) {
    const TemporaryDirectory directory;
    return read_scene(directory.write("scene.toml", text), choice);
}

}  // namespace sherd::test
