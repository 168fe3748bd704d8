// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/sweep/study/study.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

#include "app/scene/toml/override.h"
#include "app/scene/toml/toml_file.h"
#include "app/scene/toml/toml_table.h"
#include "app/sweep/study/study_measures.h"

namespace sherd {
namespace {

using Kind = Distribution::Kind;

constexpr std::int64_t most_values = 1'000'000;

constexpr std::string_view advice =
    "give a list, { from, to, steps }, { from, to, step }, or { uniform = [from, to] } or another "
    "distribution";

/// Returns a value as TOML: numbers as short as they can be, strings in double quotes where that is possible.
std::string toml_text(const toml::node& node) {
    if (const auto* text = node.as_string(); text && text->get().find_first_of("\"\\\n") == std::string::npos)
        return "\"" + text->get() + "\"";
    if (const auto* number = node.as_floating_point()) return fmt::format("{}", number->get());
    std::ostringstream text;
    text << toml::node_view<const toml::node>(node);
    return text.str();
}

std::string number_text(double value) {
    return fmt::format("{:.12g}", value);  // 0.3, not 0.30000000000000004
}

/// Reads a parameter of a study.
class ParameterReader {
  public:
    ParameterReader(const toml::node& node, std::string name, Problems& problems)
        : node(node), problems(problems) {
        parameter.name = std::move(name);
        parameter.patterns = {parameter.name + "={}"};
    }

    StudyParameter read() {
        if (const toml::array* list = node.as_array())
            read_list(*list);
        else if (const toml::table* table = node.as_table())
            read_table(*table);
        else
            report(fmt::format("is a single value; {}, or put it in `set`", advice));
        return std::move(parameter);
    }

  private:
    void report(const std::string& what) {
        problems.add(node.source(), "parameters." + parameter.name, what);
    }

    void read_list(const toml::array& list) {
        for (const toml::node& value : list) parameter.values.push_back(toml_text(value));
        if (list.empty()) report(fmt::format("is empty; {}", advice));
        if (std::ranges::any_of(parameter.values,
                                [](const std::string& text) { return text.find('\n') != std::string::npos; }))
            report("has a value of more than one line");
    }

    void read_table(const toml::table& content) {
        TomlTable table(content, "parameters." + parameter.name, problems);
        if (table.has("set")) read_patterns(*content.get("set"));
        if (table.has("values")) {
            if (const toml::array* list = content.get_as<toml::array>("values"))
                read_list(*list);
            else
                table.report("values", "must be an array");
        } else if (table.has("from")) {
            read_range(table);
        } else {
            read_distribution(table);
        }
        table.finish();
    }

    void read_patterns(const toml::node& set) {
        parameter.patterns.clear();
        const auto add = [&](const toml::node& pattern) {
            const std::string text = pattern.value_or(std::string());
            if (text.find('=') == std::string::npos || text.find("{}") == std::string::npos)
                problems.add(pattern.source(), "parameters." + parameter.name + ".set",
                             "must be KEY=VALUE with {} for the value, or an array of these: "
                             "\"sheet.plate.velocity=[0, 0, -{}]\"");
            parameter.patterns.push_back(text);
        };
        if (const toml::array* list = set.as_array())
            for (const toml::node& pattern : *list) add(pattern);
        else
            add(set);
    }

    void read_range(TomlTable& table) {
        const bool logarithmic = table.flag("log", false);
        const Range& range = logarithmic ? positive : any_number;
        const double from = table.number("from", "", range), to = table.number("to", "", range);
        std::int64_t steps = 0;
        double step = 0;
        if (table.has("step") && !logarithmic) {
            step = table.number("step", "", positive);
            const double count = std::floor((to - from) / step * (1 + 1e-9) + 1e-9) + 1;
            if (!(count >= 1 && count <= static_cast<double>(most_values)))
                table.report("step", fmt::format("must make 1 to {} values of from <= to", most_values));
            else
                steps = static_cast<std::int64_t>(count);
        } else {
            steps = table.integer("steps", 2, most_values, 0);
            if (steps == 0)
                table.report("steps", "is missing: give the number of values from `from` to `to`");
            step = (to - from) / static_cast<double>(std::max<std::int64_t>(1, steps - 1));
        }
        for (std::int64_t i = 0; i < steps; ++i) {
            const double share = static_cast<double>(i) / static_cast<double>(steps - 1);
            parameter.values.push_back(number_text(logarithmic ? from * std::pow(to / from, share)
                                                               : from + static_cast<double>(i) * step));
        }
    }

    void read_distribution(TomlTable& table) {
        constexpr std::array<std::pair<std::string_view, Kind>, 4> kinds{{{"uniform", Kind::uniform},
                                                                          {"log_uniform", Kind::log_uniform},
                                                                          {"normal", Kind::normal},
                                                                          {"lognormal", Kind::lognormal}}};
        for (const auto& [name, kind] : kinds) {
            if (!table.has(name)) continue;
            const Eigen::Vector2d ab = table.pair(
                name, "", kind == Kind::log_uniform || kind == Kind::lognormal ? positive : any_number,
                false);
            if (kind == Kind::normal && ab[1] < 0) table.report(name, "has a negative standard deviation");
            parameter.drawn = Distribution{kind, ab[0], ab[1]};
        }
        if (!parameter.drawn) report(fmt::format("has no values; {}", advice));
    }

    const toml::node& node;
    Problems& problems;
    StudyParameter parameter;
};

/// Adds the parameters in a table to `found`. A nested table comes from dotted keys, and has further
/// parameters; an inline table, in braces, describes a parameter.
void add_parameters(std::vector<std::pair<toml::source_position, StudyParameter>>& found,
                    const toml::table& table, const std::string& path, Problems& problems) {
    for (const auto& [key, node] : table) {
        const std::string name = path.empty() ? std::string(key) : fmt::format("{}.{}", path, key.str());
        if (const toml::table* inner = node.as_table(); inner && !inner->is_inline())
            add_parameters(found, *inner, name, problems);
        else
            found.emplace_back(key.source().begin, ParameterReader(node, name, problems).read());
    }
}

/// Returns the parameters in a study's table `parameters`, in the order of the file. Their dotted keys are
/// keys of the scene. Mistakes are added to the problems.
std::vector<StudyParameter> read_parameters(const toml::table& table, Problems& problems) {
    std::vector<std::pair<toml::source_position, StudyParameter>> found;
    add_parameters(found, table, "", problems);
    std::ranges::stable_sort(found, [](const auto& a, const auto& b) { return a.first < b.first; });
    std::vector<StudyParameter> parameters;
    for (auto& [place, parameter] : found) parameters.push_back(std::move(parameter));
    return parameters;
}

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

/// Reports mistakes that show only if all parameters, the design and the number of repeats are considered
/// together.
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

/// Removes the table `quick`, if there is one, and replaces keys of the study by the keys in it if `quick` is
/// true.
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
