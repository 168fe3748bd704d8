// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/scene/read/scene.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "app/messages/nearest_name.h"
#include "app/scene/keys/key.h"
#include "app/scene/read/forces.h"
#include "app/scene/read/gauges.h"
#include "app/scene/read/obstacle.h"
#include "app/scene/read/parts/fields.h"
#include "app/scene/read/parts/sheet_name.h"
#include "app/scene/read/sheet/sheet.h"
#include "app/scene/read/solver.h"
#include "app/scene/read/statics.h"
#include "app/scene/read/variant_remarks.h"
#include "app/scene/toml/override.h"
#include "app/scene/toml/settings.h"
#include "app/scene/toml/toml_file.h"
#include "app/scene/toml/toml_table.h"
#include "meshops/error.h"

namespace sherd {
namespace {

/// Reports the name of a table if it has characters other than letters, digits, _ and -, if it begins with -,
/// or if it is among the `earlier` ones. noun: word for what the table describes, "variant"; reason: why
/// characters are limited, "names a group of the recording".
void check_plain_name(TomlTable& table, const std::string& name, std::string_view noun,
                      std::string_view reason, const std::vector<std::string>& earlier) {
    if (name.find_first_not_of(name_characters) != std::string::npos || name.starts_with('-'))
        table.report("name", fmt::format("{}: write it in letters, digits, _ and -", reason));
    if (std::find(earlier.begin(), earlier.end(), name) != earlier.end() && !name.empty())
        table.report("name", fmt::format("\"{}\" is the name of another {} already", name, noun));
}

using NamedTables = std::vector<std::pair<std::string, TomlTable>>;

/// Returns the tables in `all`, the sheets or the obstacles of a scene, with their names. A table that
/// `is_whole` does not accept and whose name is similar to that of a whole one is reported and left out,
/// since its keys are most likely meant for that one. lack: what such a table lacks, "no mesh".
template <class Struct>
NamedTables without_misspelt(TomlTable& all, const Section<Struct>& section, bool (*is_whole)(TomlTable&),
                             std::string_view lack) {
    NamedTables kept;
    std::vector<std::string> whole;
    NamedTables entries = all.entries();
    for (auto& [name, table] : entries)
        if (is_whole(table)) whole.push_back(name);
    for (auto& [name, table] : entries) {
        const std::string nearest = is_whole(table) ? "" : nearest_name(name, whole);
        if (nearest.empty()) {
            kept.emplace_back(name, std::move(table));
            continue;
        }
        table.report("", fmt::format("has {}; did you mean '{}'?", lack, nearest));
        report_unknown_keys(table, section);
    }
    return kept;
}

constexpr double most_steps = 1e9;  // more steps would take decades: the step is most likely mistyped

constexpr std::array<std::string_view, 2> starts{"exempt", "error"};
constexpr std::array contact_keys{
    key<&Scene::simulation, &SimulationOptions::stepper, &StepperOptions::contact, &ContactOptions::sheets>(
        "sheets", "whether sheets and fragments keep half the sum of their thicknesses apart"),
    key<&Scene::simulation, &SimulationOptions::stepper, &StepperOptions::contact, &ContactOptions::friction>(
        "friction", "coefficient of Coulomb friction between them", {.range = not_negative}),
    key<&Scene::exempts_overlaps>(
        "start", "overlaps at the start: no contact there until the surfaces have separated, or an error",
        {.choices = starts})};
constexpr Section<Scene> contact_section{
    "Contact of sheets and fragments with each other and with themselves", contact_keys};

/// Reads the duration, which statics take from their last load factor or length of path instead. Sets the
/// default of the frame interval.
void read_duration(TomlTable& root, const KeyInfo& key, Scene& scene) {
    if (!scene.is_static())
        scene.duration = root.number(key.name, key.rules.unit, key.rules.range);
    else if (root.has(key.name))
        root.report(key.name, "is not for statics, which end at solver.load");
    if (scene.is_static())
        scene.duration =
            scene.simulation.stepper.arc_length ? scene.longest_path : scene.simulation.stepper.last_load;
    scene.frame_interval =
        std::max(scene.is_static() ? 0 : scene.duration / 100, scene.simulation.stepper.step);
}

void read_every(TomlTable& output, const KeyInfo& key, Scene& scene) {
    if (output.has(key.name))
        scene.frame_interval = output.number(key.name, key.rules.unit, key.rules.range, scene.frame_interval);
}

void read_output_fields(TomlTable& output, const KeyInfo& key, Scene& scene) {
    if (!output.has(key.name)) return;
    if (output.is_flag(key.name)) {
        const bool all = output.flag(key.name, false);
        scene.simulation.fields = {.stress = all, .curvature = all, .membrane_strain = all};
    } else {
        scene.simulation.fields = chosen_fields(output.choices(key.name, key.rules.choices, true));
    }
}

constexpr std::array output_keys{
    special_key("every", Form::number,
                "time between recorded frames, at the ends of steps; at least a given `solver.step`",
                {.unit = "s", .range = positive, .otherwise = "`duration / 100`, at least a step"},
                read_every),
    special_key("fields", Form::names | Form::flag, "fields that are recorded for each face; `true`: all",
                {.choices = field_names, .otherwise = "none"}, read_output_fields),
    key<&Scene::checkpoint_interval>("checkpoint", "wall time between checkpoints; 0: at start and end only",
                                     {.unit = "s", .range = not_negative})};
constexpr Section<Scene> output_section{"Recording", output_keys};

void read_sheets(TomlTable& root, const KeyInfo& key, Scene& scene) {
    if (auto sheets = root.table(key.name)) {
        const auto is_whole = [](TomlTable& table) { return table.has("mesh") || table.has("material"); };
        for (auto& [name, table] :
             without_misspelt(*sheets, sheet_section, is_whole, "no mesh and no material")) {
            SheetSpec& sheet = scene.sheets.emplace_back();
            sheet.name = name;
            read_section(table, sheet_section, sheet);
        }
    } else if (root.has(key.name)) {
        return;  // table() has reported that it is no table
    }
    if (scene.sheets.empty())
        root.report(key.name, "the scene has no sheet: add [sheet.NAME] with mesh and material");
}

void read_obstacles(TomlTable& root, const KeyInfo& key, Scene& scene) {
    auto obstacles = root.table(key.name);
    if (!obstacles) return;
    for (auto& [name, table] : without_misspelt(*obstacles, obstacle_section, has_shape, "no shape")) {
        ObstacleSpec obstacle;
        obstacle.name = name;
        read_section(table, obstacle_section, obstacle);
        (obstacle.free ? scene.bodies : scene.obstacles).push_back(std::move(obstacle));
    }
}

void refuse_variant(TomlTable& root, const KeyInfo& key, Scene& /*scene*/) {
    if (root.has(key.name))
        root.report(key.name,
                    "belongs at the top level of the scene: a variant cannot contain variants, and --set "
                    "cannot add one");
}

struct Variant {
    std::string name;
};

void read_variant_name(TomlTable& table, const KeyInfo& key, Variant& variant) {
    variant.name = table.string(key.name, key.rules.what);
}

constexpr std::array variant_keys{
    special_key("name", Form::name,
                "name of the variant, which becomes a part of a file's name: letters, digits, `_` and `-`",
                {.what = "the name of the variant", .required = true}, read_variant_name)};
constexpr Section<Variant> variant_section{"A variant: its name, and the keys of the scene that it changes",
                                           variant_keys};

std::vector<SectionText> inside_variant() {
    return {text_of(variant_section)};
}

constexpr Range seeds{
    .least = 0, .most = std::numeric_limits<std::uint32_t>::max(), .with_least = true, .with_most = true};

/// Keys in the order in which they are read: the meaning of a key may depend on earlier ones.
constexpr std::array scene_keys{
    part_key<solver_section>("solver", "time steps and their solution"),
    special_key("duration", Form::number, "simulated time; not in statics, which end at `solver.load`",
                {.unit = "s", .range = positive, .otherwise = "required, except in statics"}, read_duration),
    part_key<output_section>("output", "recorded data"),
    key<&Scene::seed>("seed",
                      "seed of the random numbers in generated meshes, gusts and the scatter of strength",
                      {.range = seeds}),
    special_key("sheet", Form::named, "sheets, which bend and break", {.required = true}, read_sheets,
                [] { return std::vector{text_of(sheet_section)}; }),
    special_key("obstacle", Form::named, "obstacles, which sheets cannot pass through", {.otherwise = "none"},
                read_obstacles, [] { return std::vector{text_of(obstacle_section)}; }),
    part_key<contact_section>("contact", "contact of sheets and fragments with each other"),
    part_key<force_section>("force", "gravity, loads and wind"),
    table_key<gauge_section, &Scene::gauges>("gauge", "points at which quantities are measured",
                                             {.otherwise = "none"}),
    special_key(variant_key, Form::table | Form::tables, "other versions of the scene", {.otherwise = "none"},
                refuse_variant, inside_variant)};

void require_few_steps(const Scene& scene, TomlTable& table, const char* key, const char* advice) {
    const double steps = scene.duration / scene.simulation.stepper.step;
    if (steps > most_steps)
        table.report(key,
                     fmt::format("would take {:.2g} steps, more than {:.0g}: {}", steps, most_steps, advice));
}

/// Shortens a default step to the frame interval, as frames are recorded at the ends of steps. Reports a
/// frame interval that is shorter than a step that the scene gives, or than a step of statics.
void complete_frame_interval(TomlTable& output, bool step_is_given, Scene& scene) {
    if (scene.frame_interval >= scene.simulation.stepper.step) return;
    if (step_is_given || scene.is_static())
        return output.report(
            "every", fmt::format("is shorter than solver.step ({} s), at whose ends frames are recorded",
                                 scene.simulation.stepper.step));
    scene.simulation.stepper.step = scene.frame_interval;
    require_few_steps(scene, output, "every", "give a longer one");
}

void complete_times(TomlTable& root, Scene& scene) {
    auto solver = root.table("solver"), output = root.table("output");
    const bool step_is_given = solver && solver->has("step");
    if (solver && scene.simulation.stepper.step > scene.duration)
        solver->report("step", fmt::format("is longer than {} ({} {})",
                                           !scene.is_static()                    ? "duration"
                                           : scene.simulation.stepper.arc_length ? "longest_path"
                                                                                 : "load",
                                           scene.duration, scene.time_unit()));
    if (step_is_given)
        require_few_steps(scene, *solver, "step", "give a longer one");
    else if (root.has("duration"))
        require_few_steps(scene, root, "duration", "give a shorter one, or a longer solver.step");
    if (output && output->has("every")) complete_frame_interval(*output, step_is_given, scene);
}

/// Reports fracture data that do not go with the paper's rule, which only compares hinges with their
/// strength.
void require_paper(TomlTable& root, const FractureSpec& fracture) {
    if (fracture.has_toughness())
        root.report("solver", "rule = \"paper\" does not support toughness: leave one of them out");
    if (fracture.art_direction.smallest > 0)
        root.report("solver", "rule = \"paper\" does not support fracture.smallest: leave one of them out");
}

void complete_sheets(TomlTable& root, const Scene& scene) {
    for (const SheetSpec& sheet : scene.sheets) {
        if (sheet.fracture && scene.simulation.rule == BreakingRule::paper)
            require_paper(root, *sheet.fracture);
        // Coupled hinges always have the rigidity of a plate; only other hinges can be calibrated.
        if (scene.simulation.stepper.shell.bending.model == BendingModel::coupled &&
            sheet.material.calibration == Calibration::paper)
            root.report("sheet",
                        fmt::format("{}: its material's calibration = \"paper\" is for the paper's "
                                    "bending models: add solver.bending = \"cubic\", or leave it out",
                                    sheet.name));
    }
}

void complete_gauges(TomlTable& root, const Scene& scene) {
    std::vector<TomlTable> tables = root.tables("gauge");
    std::vector<std::string> names;
    for (std::size_t i = 0; i < tables.size(); ++i) {
        check_sheet_name(tables[i], scene);
        if (scene.gauges[i].name.empty()) continue;  // the missing name has been reported
        check_plain_name(tables[i], scene.gauges[i].name, "gauge", "names a group of the recording", names);
        names.push_back(scene.gauges[i].name);
    }
}

void complete_scene(TomlTable& root, Scene& scene) {
    complete_times(root, scene);
    complete_sheets(root, scene);
    complete_gauges(root, scene);
    if (scene.is_static()) require_statics(root, scene);
}

constexpr Section<Scene> scene_section{"The scene", scene_keys, complete_scene};

bool is_scene_key(std::string_view name) {
    return std::ranges::any_of(scene_keys, [&](const Key<Scene>& key) { return key.info.name == name; });
}

/// Returns the names of the `[[variant]]`s of a scene, in the order of the file. Reports a name that is
/// missing, that cannot be part of a file's name, or that another variant has. Without a name, keys of the
/// variant that are no keys of scenes are reported, too, since the name may be the value of one of them.
std::vector<std::string> read_variant_names(TomlTable& root) {
    std::vector<std::string> names;
    for (TomlTable& table : root.tables(variant_key)) {
        Variant variant;
        read_keys(table, variant_section, variant);
        check_plain_name(table, variant.name, "variant", "becomes a part of a file's name", names);
        names.push_back(variant.name);
        if (variant.name.empty()) report_unknown_keys(table, scene_section);
    }
    return names;
}

/// Removes from a variant its name, and keys that are no keys of scenes if read_variant_names() has reported
/// them.
void drop_read_keys(toml::table& variant) {
    const bool has_name = !variant["name"].value_or(std::string()).empty();
    variant.erase("name");
    for (auto key = variant.begin(); key != variant.end();)
        key = has_name || is_scene_key(key->first.str()) ? std::next(key) : variant.erase(key);
}

/// Removes all variants from `scene`, and puts the keys of the variant of this number, if there is one, into
/// it by merge_keys().
void apply_variant(toml::table& scene, std::optional<std::size_t> number) {
    const toml::node_view<toml::node> variants = scene[variant_key];
    std::vector<toml::table*> candidates;
    if (toml::table* only = variants.as_table()) candidates.push_back(only);
    if (toml::array* array = variants.as_array())
        for (toml::node& node : *array)
            if (toml::table* table = node.as_table()) candidates.push_back(table);
    toml::table changes;
    if (number) changes = std::move(*candidates.at(*number));
    drop_read_keys(changes);
    scene.erase(variant_key);
    merge_keys(scene, std::move(changes));
}

/// Returns the number of the variant that a scene has chosen by its name; none if it has chosen none. Throws
/// Error if there is no variant of this name.
std::optional<std::size_t> chosen_number(const Scene& scene, const std::vector<std::string>& names,
                                         const Problems& problems) {
    if (scene.variant.empty()) return std::nullopt;
    const auto found = std::find(names.begin(), names.end(), scene.variant);
    if (found != names.end()) return static_cast<std::size_t>(found - names.begin());
    problems.throw_if_any();  // a variant whose name is wrong may be the one that is meant
    const std::string nearest = nearest_name(scene.variant, names);
    throw Error(fmt::format(
        "--variant {}: {} has no variant of this name; {}{}", scene.variant, scene.file.string(),
        nearest.empty() ? "" : fmt::format("did you mean '{}'? ", nearest),
        names.empty() ? "it has no variants at all" : fmt::format("it has: {}", fmt::join(names, ", "))));
}

/// Reads a scene as parse_scene() does. number: of the variant; none: the one that `choice` names.
Scene read_variant(std::string text, const std::filesystem::path& file, const SceneChoice& choice,
                   GivenMeshes meshes, std::optional<std::size_t> number) {
    Scene scene;
    scene.given_meshes = std::move(meshes);
    scene.file = file;
    scene.variant = choice.variant;
    toml::table document = parse_toml(text, file);
    scene.text = recorded_text(std::move(text), choice);
    Problems problems;
    TomlTable whole(document, "", problems);
    const std::vector<std::string> names = read_variant_names(whole);
    apply_variant(document, number ? number : chosen_number(scene, names, problems));
    for (const std::string& assignment : choice.overrides) apply_override(document, assignment);
    scene.settings = settings_of(document);
    TomlTable root(document, "", problems, file.parent_path());
    read_section(root, scene_section, scene);
    problems.throw_if_any();
    return scene;
}

}  // namespace

SectionText scene_reference() {
    return text_of(scene_section);
}

std::string read_scene_text(const std::filesystem::path& file) {
    return read_toml_text(file, "scene");
}

std::vector<std::string> variant_names(const std::string& text, const std::filesystem::path& file) {
    const toml::table document = parse_toml(text, file);
    Problems problems;
    TomlTable root(document, "", problems);
    std::vector<std::string> names = read_variant_names(root);
    problems.throw_if_any();
    return names;
}

Scene read_scene(const std::filesystem::path& file, const SceneChoice& choice) {
    return parse_scene(read_scene_text(file), file, choice);
}

Scene parse_scene(std::string text, const std::filesystem::path& file, const SceneChoice& choice,
                  GivenMeshes meshes) {
    return read_variant(std::move(text), file, choice, std::move(meshes), std::nullopt);
}

std::vector<Scene> parse_scenes(const std::string& text, const std::filesystem::path& file,
                                const SceneChoice& choice) {
    const toml::table document = parse_toml(text, file);
    Problems told_with_each_scene;
    TomlTable root(document, "", told_with_each_scene);
    const std::vector<std::string> names = read_variant_names(root);
    if (names.empty() || !choice.variant.empty()) return {parse_scene(text, file, choice)};
    std::vector<Scene> scenes;
    VariantRemarks mistakes;
    for (std::size_t i = 0; i < names.size(); ++i) {
        const std::string name = names[i].empty() ? fmt::format("number {}", i + 1) : names[i];
        try {
            scenes.push_back(read_variant(text, file, {choice.overrides, names[i]}, {}, i));
            mistakes.add(name, "");
        } catch (const Error& error) {
            mistakes.add(name, error.what());
        }
    }
    mistakes.throw_if_any();
    return scenes;
}

}  // namespace sherd
