// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/help/scene_schema.h"

#include "app/help/key_reference.h"
#include "app/scene/read/scene.h"

namespace sherd {
namespace {

/// Whether a schema is for a whole table, or for keys that a variant merges into a table, which has the
/// required ones already.
enum class Extent { whole, merged };

Json section_schema(const SectionText& section, Extent extent);

/// Returns the schema of a number in a range. The bounds that TomlTable sets for all numbers are left out.
Json number_schema(const Range& range, const char* type) {
    Json schema{{"type", type}};
    if (range.has_least()) schema[range.with_least ? "minimum" : "exclusiveMinimum"] = range.least;
    if (range.has_most()) schema[range.with_most ? "maximum" : "exclusiveMaximum"] = range.most;
    return schema;
}

Json array_schema(const Json& items, std::size_t least, std::size_t most) {
    Json schema{{"type", "array"}, {"items", items}, {"minItems", least}};
    if (most > 0) schema["maxItems"] = most;
    return schema;
}

Json choice_schema(std::span<const std::string_view> names) {
    Json values = Json::array();
    for (const std::string_view name : names) values.push_back(name);
    return {{"enum", values}};
}

/// Returns the schema of values that match at least one of the schemas.
Json any_of(std::vector<Json> schemas) {
    if (schemas.size() == 1) return schemas[0];
    return {{"anyOf", schemas}};
}

/// Returns the schema of a Form::name.
Json name_schema() {
    // The last of the characters is -, which therefore means itself within brackets.
    static_assert(name_characters.ends_with('-'));
    return {{"type", "string"}, {"pattern", "^(?!-)[" + std::string(name_characters) + "]+$"}};
}

/// Returns the schema of an array of different names.
Json names_schema(std::span<const std::string_view> names) {
    Json schema = array_schema(choice_schema(names), 1, names.size());
    schema["uniqueItems"] = true;
    return schema;
}

/// Returns the schema of a table of tables with names that the user chooses.
Json named_schema(const Json& inside, bool needs_one) {
    Json schema{{"type", "object"}, {"additionalProperties", inside}};
    if (needs_one) schema["minProperties"] = 1;
    return schema;
}

Json inside_schema(const KeyText& key, Extent extent) {
    if (key.inside.empty()) return {{"type", "object"}};
    std::vector<Json> kinds;
    for (const SectionText& kind : key.inside) kinds.push_back(section_schema(kind, extent));
    return any_of(std::move(kinds));
}

Json value_schema(const KeyText& key, Extent extent) {
    const KeyRules& rules = key.info.rules;
    const Json number{{"type", "number"}}, row = array_schema(number, rules.columns, rules.columns),
                                           rows = array_schema(row, rules.least_rows, rules.most_rows),
                                           ranged = number_schema(rules.range, "number");
    std::vector<Json> forms;
    const auto add = [&](Form form, const auto& schema) {
        if (has_form(key.info.forms, form)) forms.push_back(schema());
    };
    add(Form::number, [&]() -> const Json& { return ranged; });
    add(Form::integer, [&] { return number_schema(rules.range, "integer"); });
    add(Form::flag, [] { return Json{{"type", "boolean"}}; });
    add(Form::text, [] { return Json{{"type", "string"}, {"minLength", 1}}; });
    add(Form::name, [] { return name_schema(); });
    add(Form::file, [] { return Json{{"type", "string"}, {"minLength", 1}}; });
    add(Form::choice, [&] { return choice_schema(rules.choices); });
    add(Form::names, [&] { return names_schema(rules.choices); });
    add(Form::vector, [&] { return array_schema(number, 3, 3); });
    add(Form::pair, [&] { return array_schema(ranged, 2, 2); });
    add(Form::rows, [&]() -> const Json& { return rows; });
    add(Form::lists_of_rows, [&] { return array_schema(rows, 0, 0); });
    add(Form::table, [&] { return inside_schema(key, extent); });
    // An array in a variant replaces the whole array of the scene.
    add(Form::tables, [&] { return array_schema(inside_schema(key, Extent::whole), 0, 0); });
    add(Form::named,
        [&] { return named_schema(inside_schema(key, extent), rules.required && extent == Extent::whole); });
    return any_of(std::move(forms));
}

Json key_schema(const KeyText& key, Extent extent) {
    Json schema = value_schema(key, extent);
    const std::string without = default_text(key);
    std::string text(key.info.sentence);
    if (!key.info.rules.unit.empty()) text += " (" + std::string(key.info.rules.unit) + ")";
    if (!without.empty()) text += key.info.rules.required ? "; required" : "; default: " + without;
    schema["description"] = text;
    return schema;
}

Json section_schema(const SectionText& section, Extent extent) {
    Json properties = Json::object(), required = Json::array(), conflicts = Json::array();
    for (const KeyText& key : section.keys) {
        properties[std::string(key.info.name)] = key_schema(key, extent);
        if (key.info.rules.required && extent == Extent::whole) required.push_back(key.info.name);
        for (const std::string_view other : key.info.rules.excludes)
            if (!other.empty())
                conflicts.push_back({{"not", {{"required", Json::array({key.info.name, other})}}}});
    }
    Json schema{{"type", "object"},
                {"description", section.title},
                {"properties", properties},
                {"additionalProperties", false}};
    if (!required.empty()) schema["required"] = required;
    if (!conflicts.empty()) schema["allOf"] = conflicts;
    return schema;
}

/// Returns the schema of a variant: the keys of `variant`, such as its name, and any others of the scene.
/// Required keys of tables may be missing, since the scene has them. (A table in braces replaces that of the
/// scene, so that it does need them, but a schema cannot tell it from the others.)
Json variant_schema(const SectionText& scene, const SectionText& variant) {
    Json schema = section_schema(variant, Extent::whole);
    const Json merged = section_schema(scene, Extent::merged);
    for (const auto& [name, key] : merged["properties"].items())
        if (name != variant_key) schema["properties"][name] = key;
    return schema;
}

}  // namespace

Json scene_schema() {
    const SectionText scene = scene_reference();
    Json schema = section_schema(scene, Extent::whole);
    for (const KeyText& key : scene.keys)
        if (key.info.name == variant_key) {
            const Json variant = variant_schema(scene, key.inside.front());
            schema["properties"][variant_key]["anyOf"] = Json::array({variant, array_schema(variant, 0, 0)});
        }
    schema["title"] = "A scene of Sherd";
    // A static scene ends at the load solver.load and must not have a duration; scenes with other schemes
    // need one.
    schema["if"] = {
        {"properties",
         {{"solver", {{"properties", {{"scheme", {{"const", "static"}}}}}, {"required", {"scheme"}}}}}},
        {"required", {"solver"}}};
    schema["then"] = {{"not", {{"required", {"duration"}}}}};
    schema["else"] = {{"required", {"duration"}}};
    Json result{{"$schema", "https://json-schema.org/draft/2020-12/schema"}};
    result.update(schema);
    return result;
}

}  // namespace sherd
