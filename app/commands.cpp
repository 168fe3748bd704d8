// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands.h"

namespace sherd {

void add_scene_options(CLI::App& command, SceneOptions& options) {
    command.add_option("scene", options.file, "Scene file (TOML; keys in scenes/README.md)")
        ->required()
        ->option_text("SCENE.toml");
    command
        .add_option("--set", options.overrides,
                    "Override a key of the scene, such as solver.step=1e-4; repeatable")
        ->option_text("KEY=VALUE ...")
        ->allow_extra_args(false);
}

}  // namespace sherd
