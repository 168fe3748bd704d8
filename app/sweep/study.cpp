// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/sweep/study.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>

#include "app/scene/toml/override.h"
#include "app/scene/toml/toml_file.h"
#include "app/scene/toml/toml_table.h"
#include "app/sweep/study_column_names.h"
#include "app/sweep/study_measures.h"
#include "app/sweep/study_parameter.h"

namespace sherd {
namespace {

constexpr std::int64_t most_samples = 10'000'000;

/// Reads an array of strings; `what` describes them in messages.
std::vector<std::string> read_texts(TomlTable& root, const toml::table& document, const char* key,
                                    const char* what) {
    std::vector<std::string> texts;
    if (!root.has(key)) return texts;
    const toml::array* array = document.get_as<toml::array>(key);
    for (std::size_t i = 0; array && i < array->size(); ++i)
        if (const auto* text = array->get(i)->as_string()) texts.push_back(text->get());
    if (!array || texts.size() != array->size())
        root.report(key, fmt::format("must be an array of {} in quotes", what));
    return texts;
}

void read_design(TomlTable& root, Study& study) {
    constexpr std::array<std::string_view, 4> designs{"grid", "zip", "latin", "random"};
    if (root.has("design")) study.design = static_cast<Design>(root.choice_number("design", designs));
    const bool draws = study.design == Design::latin || study.design == Design::random;
    study.samples = root.integer("samples", 1, most_samples, 0);
    if (draws && study.samples == 0)
        root.report("samples",
                    "is missing: give the number of rows that design = \"latin\" or \"random\" makes");
    if (!draws && study.samples != 0)
        root.report("samples", "is for design = \"latin\" or \"random\"; leave it out, or give one of these");
    study.seed = root.integer("seed", 0, std::numeric_limits<std::uint32_t>::max(), study.seed);
    study.repeats = root.integer("repeats", 1, most_samples, study.repeats);
}

/// Reports mistakes that only all parameters together show.
void require_rows(TomlTable& root, const Study& study) {
    const bool draws = study.design == Design::latin || study.design == Design::random;
    double rows = static_cast<double>(draws ? study.samples : 1);
    for (const StudyParameter& parameter : study.parameters) {
        if (!draws && parameter.drawn)
            root.report("parameters",
                        fmt::format("{} has a distribution, which needs design = \"latin\" or \"random\"",
                                    parameter.name));
        if (study.design == Design::grid)
            rows *= static_cast<double>(std::max<std::size_t>(1, parameter.values.size()));
        if (study.design == Design::zip && parameter.values.size() != study.parameters[0].values.size())
            root.report(
                "parameters",
                fmt::format(
                    "{} has {} values and {} has {}; with design = \"zip\" all must have the same number",
                    study.parameters[0].name, study.parameters[0].values.size(), parameter.name,
                    parameter.values.size()));
        if (parameter.name != "seed" && is_study_column(parameter.name))
            root.report("parameters",
                        fmt::format("{} is the name of another column of the table: use another name",
                                    parameter.name));
        if (parameter.name == "seed" && study.repeats > 1)
            root.report("repeats", "differ by the scene's seed, which is a parameter already: leave one out");
    }
    if (study.design == Design::zip && !study.parameters.empty())
        rows = static_cast<double>(study.parameters[0].values.size());
    if (rows * static_cast<double>(study.repeats) > static_cast<double>(most_samples))
        root.report("parameters", fmt::format("would make {:.2g} rows, more than {:.0g}",
                                              rows * static_cast<double>(study.repeats),
                                              static_cast<double>(most_samples)));
}

void read_centre(TomlTable& root, CrackCentre& centre) {
    if (root.is_string("about"))
        centre.obstacle = root.string("about", "the name of an obstacle");
    else if (root.has("about"))
        centre.point = root.vector("about", "m");
    if (root.has("radius")) centre.radii = {root.number("radius", "m", positive)};
}

void read_measures(TomlTable& root, const toml::table& document, Study& study) {
    study.measures = read_texts(root, document, "measures", "names of measures");
    for (const std::string& name : study.measures)
        if (const std::string mistake = measure_error(name); !mistake.empty())
            root.report("measures", mistake);
    study.over = root.number("over", "kg", not_negative, 0.);
    read_centre(root, study.centre);
    if (root.has("python")) study.python = root.string("python", "a Python file");
    constexpr std::array<std::string_view, 3> keeps{"none", "failed", "all"};
    if (root.has("keep")) study.keep = static_cast<Keep>(root.choice_number("keep", keeps));
}

SlurmOptions read_slurm(TomlTable& table) {
    SlurmOptions slurm;
    for (const auto& [key, value] : {std::pair{"partition", &slurm.partition},
                                     {"account", &slurm.account},
                                     {"time", &slurm.time},
                                     {"memory", &slurm.memory}})
        if (table.has(key)) *value = table.string(key, "a value for sbatch");
    slurm.chunk = static_cast<std::size_t>(table.integer("chunk", 1, most_samples, 0));
    table.finish();
    return slurm;
}

/// Removes the table `quick`, if there is one, and puts its keys over the others if `quick` is true.
void apply_quick(toml::table& document, bool quick) {
    toml::table* changes = document.get_as<toml::table>("quick");
    if (!changes) return;
    toml::table taken = std::move(*changes);
    document.erase("quick");
    if (quick) merge_keys(document, std::move(taken));
}

}  // namespace

Study read_study(const std::filesystem::path& file, bool quick) {
    return parse_study(read_toml_text(file, "study"), file, quick);
}

Study parse_study(const std::string& text, const std::filesystem::path& file, bool quick) {
    toml::table document = parse_toml(text, file);
    Problems problems;
    apply_quick(document, quick);
    TomlTable root(document, "", problems);
    Study study;
    study.file = file;
    study.scene = root.string("scene", "a scene's file, or the name of one that 'sherd scenes' lists,");
    if (root.has("variant")) study.variant = root.string("variant", "the name of a variant");
    study.set = read_texts(root, document, "set", "KEY=VALUE");
    read_design(root, study);
    if (root.table("parameters"))
        study.parameters = read_parameters(*document.get_as<toml::table>("parameters"), problems);
    require_rows(root, study);
    read_measures(root, document, study);
    if (auto slurm = root.table("slurm")) study.slurm = read_slurm(*slurm);
    root.finish();
    problems.throw_if_any();
    return study;
}

}  // namespace sherd
