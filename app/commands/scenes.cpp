// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <memory>

#include "app/commands/commands.h"
#include "app/files/disk/pending_file.h"
#include "app/help/key_reference.h"
#include "app/help/scene_schema.h"
#include "app/json/json.h"
#include "app/messages/print.h"
#include "app/messages/wrapped.h"
#include "app/scene/read/scene.h"
#include "app/scene/read/shipped_scenes.h"
#include "meshops/error.h"

namespace sherd {
namespace {

namespace fs = std::filesystem;

struct ScenesOptions {
    std::string copy;  ///< name of a scene; empty: list them
    fs::path folder = ".";
    bool force = false, json = false, schema = false, markdown = false;
    std::string settable;             ///< a scene whose dotted keys are listed; empty: none
    std::optional<std::string> keys;  ///< table or key that is described; "": all keys; none: not wanted
};

void print_list(const std::vector<ShippedScene>& scenes) {
    std::size_t widest = 0;
    for (const ShippedScene& scene : scenes) widest = std::max(widest, scene.name.size());
    const std::size_t indent = widest + 2, columns = terminal_columns();
    for (const ShippedScene& scene : scenes)
        print_result("{:<{}}{}\n", scene.name, indent,
                     columns < indent + 20 ? scene.description
                                           : wrapped(scene.description, columns - indent - 1, indent));
}

void print_json(const std::vector<ShippedScene>& scenes) {
    Json list = Json::array();
    for (const ShippedScene& scene : scenes)
        list.push_back(
            {{"name", scene.name}, {"file", scene.file.string()}, {"description", scene.description}});
    print_result("{}\n", list.dump(2));
}

/// Prints the dotted keys of a scene, each with its allowed words, for completion.
void print_settable(const std::string& given) {
    std::vector<std::string> sheets, obstacles;
    try {
        const fs::path file = find_scene(given);
        const Scene scene = read_scene(file);
        for (const SheetSpec& sheet : scene.sheets) sheets.push_back(sheet.name);
        for (const auto* specs : {&scene.obstacles, &scene.bodies})
            for (const ObstacleSpec& obstacle : *specs) obstacles.push_back(obstacle.name);
    } catch (const Error&) {
        // A scene that cannot be read has no names yet.
    }
    for (const std::string& line : settable_lines(sheets, obstacles)) print_result("{}\n", line);
}

/// Copies a scene and the files that it names into a folder, and prints the paths of the copies.
void copy_scene(const ShippedScene& scene, const ScenesOptions& options) {
    std::vector<fs::path> files = files_of_scene(scene.file);
    files.insert(files.begin(), scene.file.filename());
    for (const fs::path& file : files) check_free(options.folder / file, options.force);
    make_folder(options.folder);
    for (const fs::path& file : files) {
        const fs::path copy = (options.folder / file).lexically_normal();
        const OutputLock lock(copy);
        PendingFile pending(lock, Fault::input);
        fs::copy_file(scene.file.parent_path() / file, pending.path(), fs::copy_options::overwrite_existing);
        pending.publish(options.force);
        print_result("{}\n", copy.string());
    }
}

int scenes(const ScenesOptions& options) {
    if (options.schema) {
        print_result("{}\n", scene_schema().dump(2));
        return 0;
    }
    if (!options.settable.empty()) {
        print_settable(options.settable);
        return 0;
    }
    if (options.markdown && !options.keys) throw Error("--markdown is for --keys");
    if (options.keys) {
        print_result("{}", options.markdown ? key_tables(*options.keys)
                                            : key_reference(*options.keys, terminal_columns()));
        return 0;
    }
    const fs::path folder = shipped_scene_folder();
    const std::vector<ShippedScene> shipped = shipped_scenes(folder);
    if (!options.copy.empty())
        copy_scene(shipped_scene(options.copy, shipped), options);
    else if (options.json)
        print_json(shipped);
    else
        print_list(shipped);
    return 0;
}

}  // namespace

void add_scenes(CLI::App& program, Command& chosen) {
    CLI::App* command =
        program.add_subcommand("scenes", "List the scenes that come with the program, or copy one");
    auto options = std::make_shared<ScenesOptions>();
    CLI::Option* copy =
        command->add_option("--copy", options->copy, "Copy this scene, and the files it names, to edit it")
            ->option_text("SCENE");
    command
        ->add_option("-o,--output", options->folder, "Folder for the copy (default: the working directory)")
        ->option_text("FOLDER")
        ->needs(copy);
    command->add_flag("--force", options->force, "Replace files that exist")->needs(copy);
    CLI::Option* json =
        command->add_flag("--json", options->json, "For scripts: name, file and description of each")
            ->excludes(copy);
    CLI::Option* keys =
        command
            ->add_option("--keys", options->keys,
                         "Keys of scenes, of one table or one key alone: values, defaults and meaning")
            ->option_text("[TABLE]")
            ->expected(0, 1)
            ->excludes(copy)
            ->excludes(json);
    command->add_flag("--schema", options->schema, "For editors: the JSON Schema of scenes")
        ->excludes(copy)
        ->excludes(keys);
    command->add_flag("--markdown", options->markdown, "For pages: tables of Markdown")->group("");
    command->add_option("--settable", options->settable, "For completion: dotted keys of a scene")->group("");
    command->footer(
        "Any command accepts the name of a scene in place of a file.\n"
        "Examples:\n"
        "  sherd scenes\n"
        "  sherd run plate_drop\n"
        "  sherd scenes --keys solver\n"
        "  sherd scenes --copy bowl_on_anvil -o my_scenes");
    command->callback([&chosen, options] { chosen = [options] { return scenes(*options); }; });
}

}  // namespace sherd
