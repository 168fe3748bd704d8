// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "app/scene/assemble/built_scene.h"
#include "app/scene/read/scene.h"
#include "tests/support/program/temporary_directory.h"

namespace sherd::test {

/// Scene read from a text, and the input of its simulation.
struct BuiltText {
    Scene scene;
    BuiltScene built;
};

inline BuiltText built_from(const std::string& text) {
    const TemporaryDirectory directory;
    Scene scene = read_scene(directory.write("scene.toml", text));
    std::vector<std::string> warnings;
    BuiltScene built = build_scene(scene, warnings);
    return {std::move(scene), std::move(built)};
}

inline std::unique_ptr<Simulation> simulation_of(const std::string& text) {
    BuiltText prepared = built_from(text);
    return std::make_unique<Simulation>(std::move(prepared.built.sheets), prepared.built.options);
}

}  // namespace sherd::test
