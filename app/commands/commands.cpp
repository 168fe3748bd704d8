// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/commands.h"

#include "app/files/disk/pending_file.h"
#include "app/scene/read/scene.h"
#include "app/scene/read/shipped_scenes.h"

namespace sherd {

void add_scene_options(CLI::App& command, SceneOptions& options) {
    command
        .add_option_function<std::string>(
            "scene", [&options](const std::string& given) { options.file = find_scene(given); },
            "Scene file (TOML; keys in docs/scene.md), or the name of one that 'sherd scenes' lists")
        ->required()
        ->option_text("SCENE.toml");
    command
        .add_option("--variant", options.choice.variant,
                    "Use this [[variant]] of the scene (default: all variants)")
        ->option_text("NAME");
    command
        .add_option("--set", options.choice.overrides,
                    "Override a key of the scene, such as solver.step=1e-4; repeatable")
        ->option_text("KEY=VALUE ...")
        ->allow_extra_args(false);
}

std::filesystem::path part_file(const std::filesystem::path& file, const std::string& part) {
    std::filesystem::path named = file;
    if (!part.empty()) named.replace_filename(file.stem().string() + "-" + part + file.extension().string());
    return named;
}

void require_no_input(const std::filesystem::path& output, const Scene& scene) {
    std::vector<std::filesystem::path> inputs = input_files(scene);
    inputs.push_back(scene.file);
    check_free(output, true, inputs);
}

namespace {

/// Path of a scene's text, for messages. Names of files in the scene are relative to its folder: to the
/// working folder if the text comes through a pipe, as from /dev/stdin.
std::filesystem::path origin_of(const std::filesystem::path& file) {
    return std::filesystem::is_fifo(file) ? "pipe" : file;
}

}  // namespace

std::vector<Scene> read_scenes(const SceneOptions& options) {
    const std::string text = read_scene_text(options.file);  // once: a pipe cannot be read again
    return parse_scenes(text, origin_of(options.file), options.choice);
}

}  // namespace sherd
