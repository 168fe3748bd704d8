// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/sweep/study_parameter.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>

namespace sherd {
namespace {

using Kind = Distribution::Kind;

constexpr std::int64_t most_values = 1'000'000;
constexpr std::string_view advice =
    "give a list, { from, to, steps }, { from, to, step }, or { uniform = [from, to] } or another "
    "distribution";

/// A value as TOML: numbers as short as they can be, strings in double quotes where that is possible.
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

/// Reads a parameter.
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

/// Adds the parameters in a table. Dotted keys are tables in tables; a table in braces is a parameter.
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

}  // namespace

std::vector<StudyParameter> read_parameters(const toml::table& table, Problems& problems) {
    std::vector<std::pair<toml::source_position, StudyParameter>> found;
    add_parameters(found, table, "", problems);
    std::ranges::stable_sort(found, [](const auto& a, const auto& b) { return a.first < b.first; });
    std::vector<StudyParameter> parameters;
    for (auto& [place, parameter] : found) parameters.push_back(std::move(parameter));
    return parameters;
}

}  // namespace sherd
