// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/scene/read/sheet/material.h"

#include <fmt/format.h>

#include <cmath>

#include "app/scene/keys/key.h"
#include "app/scene/material_axis.h"
#include "app/scene/read/parts/map_source.h"

namespace sherd {
namespace {

/// Returns the direction in `axis`. An axis of another kind is replaced by a default direction.
AxisDirection& as_direction(MaterialAxis& axis) {
    if (auto* direction = std::get_if<AxisDirection>(&axis.kind)) return *direction;
    return axis.kind.emplace<AxisDirection>();
}

void read_axis_direction(TomlTable& table, const KeyInfo& key, MaterialAxis& axis) {
    if (!table.has(key.name)) return;
    Eigen::Vector3d& direction = as_direction(axis).direction;
    direction = table.vector(key.name, "").stableNormalized();
    if (direction.isZero(0)) table.report(key.name, "must not be zero: give one such as [1, 0, 0]");
}

void read_degrees(TomlTable& table, const KeyInfo& key, MaterialAxis& axis) {
    if (table.has(key.name)) as_direction(axis).degrees = table.number(key.name, key.rules.unit, any_number);
}

void read_axis_texture(TomlTable& table, const KeyInfo& key, MaterialAxis& axis) {
    if (table.has(key.name)) axis.kind = AxisTexture{table.file(key.name, key.rules.what)};
}

void read_encoding(TomlTable& table, const KeyInfo& key, MaterialAxis& axis) {
    if (!table.has(key.name)) return;
    if (auto* texture = std::get_if<AxisTexture>(&axis.kind))
        read_value(table, key, texture->encoding);
    else
        table.report(key.name, "needs texture");
}

void read_field(TomlTable& table, const KeyInfo& key, MaterialAxis& axis) {
    if (!table.has(key.name)) return;
    if (!table.flag(key.name, true)) table.report(key.name, "must be true, or left out");
    axis.kind = AxisField{};
}

void complete_axis(TomlTable& table, MaterialAxis& axis) {
    const bool direction = table.has("direction"), texture = table.has("texture"), field = table.has("field");
    if ((direction || table.has("degrees")) + texture + field != 1)
        table.report("", "needs direction, degrees or both, or texture, or field");
    axis.where = table.where(direction ? "direction" : texture ? "texture" : field ? "field" : "");
}

constexpr std::array<std::string_view, 2> encodings{"hue", "vector"};

constexpr std::array axis_keys{
    special_key("direction", Form::vector, "the axis, in the frame of the mesh, projected to each face",
                {.otherwise = "`[1, 0, 0]`"}, read_axis_direction),
    special_key("degrees", Form::number, "angle by which the direction is turned about the face's normal",
                {.unit = "degrees", .otherwise = "0"}, read_degrees),
    special_key("texture", Form::file, "a PNG file, looked up at the middle of each face",
                {.what = "the name of a PNG file", .otherwise = "none"}, read_axis_texture),
    special_key("encoding", Form::choice, "how the texture encodes an angle",
                {.choices = encodings, .otherwise = "`\"hue\"`"}, read_encoding),
    special_key("field", Form::flag,
                "`true`: the axis is in the face properties `axis_x`, `axis_y`, `axis_z` of a PLY file",
                {.otherwise = "`false`"}, read_field)};

constinit const Section<MaterialAxis> axis_section{"Direction of the first material axis", axis_keys,
                                                   complete_axis};

constexpr Range poisson_range{.least = -1, .most = 0.5};
constexpr double usual_poisson = 0.3;

/// Returns the preset's value of a material constant, which makes the constant's key optional; none without a
/// preset.
std::optional<double> from_preset(const SheetSpec& sheet, double Material::*member) {
    return sheet.preset != nullptr ? std::optional(sheet.preset->material.*member) : std::nullopt;
}

void read_preset(TomlTable& table, const KeyInfo& key, SheetSpec& sheet) {
    if (!table.has(key.name)) return;
    // An unknown preset is one mistake: keys that a preset makes optional are not reported as missing, too.
    static constexpr MaterialPreset unknown{"", {}, FracturePreset{}};
    sheet.preset = &unknown;
    const std::string name = table.choice(key.name, key.rules.choices);
    for (const MaterialPreset& known : material_presets())
        if (known.name == name) sheet.preset = &known;
}

void read_density(TomlTable& table, const KeyInfo& key, SheetSpec& sheet) {
    sheet.material.density =
        table.number(key.name, key.rules.unit, key.rules.range, from_preset(sheet, &Material::density));
}

void complete_thickness(TomlTable& table, ThicknessMap& map) {
    map.where = complete_map_source(table);
    if (!map.range && std::holds_alternative<MapTexture>(map.source) && !table.has("scale"))
        table.report("", "needs range, the thickness (m) of black and of white");
}

constexpr auto thickness_keys =
    joined(embedded<map_source_keys, &ThicknessMap::source>(),
           std::array{key<&ThicknessMap::range>(
                          "range", "`[a, b]`: `a` where the value is 0 and `b` where it is 1, linear between",
                          {.unit = "m", .range = positive, .otherwise = "by `scale`"}),
                      key<&ThicknessMap::scale>("scale", "thickness where the value is 1",
                                                {.unit = "m", .range = positive, .excludes = {"range"}})});
constexpr Section<ThicknessMap> thickness_section{"A map of the thickness", thickness_keys,
                                                  complete_thickness};

void read_thickness(TomlTable& table, const KeyInfo& key, SheetSpec& sheet) {
    if (table.is_table(key.name))
        keys::read_table(table, key, thickness_section, sheet.thickness);
    else
        sheet.material.thickness =
            table.number(key.name, key.rules.unit, key.rules.range, from_preset(sheet, &Material::thickness));
}

std::vector<SectionText> inside_thickness() {
    return {text_of(thickness_section)};
}

void read_young(TomlTable& table, const KeyInfo& key, SheetSpec& sheet) {
    Material& material = sheet.material;
    if (table.is_array(key.name)) {
        const Eigen::Vector2d young = table.pair(key.name, key.rules.unit, key.rules.range);
        material.young = young[0];
        material.young1 = young[1];
    } else if (sheet.preset != nullptr && !table.has(key.name)) {
        material.young = sheet.preset->material.young;
        material.young1 = sheet.preset->material.young1;
        material.shear = sheet.preset->material.shear;
    } else {
        material.young = table.number(key.name, key.rules.unit, key.rules.range);
    }
}

void read_poisson(TomlTable& table, const KeyInfo& key, SheetSpec& sheet) {
    if (table.has("young01")) return;
    sheet.material.poisson =
        table.number(key.name, "", is_isotropic(sheet.material) ? poisson_range : any_number,
                     from_preset(sheet, &Material::poisson).value_or(usual_poisson));
}

void read_young01(TomlTable& table, const KeyInfo& key, SheetSpec& sheet) {
    if (!table.has(key.name)) return;
    Material& material = sheet.material;
    material.poisson =
        table.number(key.name, key.rules.unit, any_number) / material.young1.value_or(material.young);
}

void read_yield(TomlTable& table, const KeyInfo& key, SheetSpec& sheet) {
    if (table.has(key.name))
        sheet.material.yield = table.number(key.name, key.rules.unit, key.rules.range);
    else
        sheet.material.yield = from_preset(sheet, &Material::yield).value_or(0);
}

void check_constants(TomlTable& table, const Material& material) {
    const Orthotropy m = elastic_constants(material);
    // Constants that are NaN have been reported already.
    if (!std::isfinite(m.young0 + m.young1 + m.young01 + material.shear.value_or(0))) return;
    const std::string broken = broken_inequality(m);
    if (broken.empty()) return;
    const bool by_young01 = table.has("young01");
    table.report(by_young01             ? "young01"
                 : table.has("poisson") ? "poisson"
                                        : "young",
                 fmt::format("is inadmissible, {}: {} must be below {:.4g}", broken,
                             by_young01 ? "its magnitude" : "poisson (nu01)",
                             by_young01 ? std::sqrt(m.young0 * m.young1) : std::sqrt(m.young0 / m.young1)));
}

void complete_material(TomlTable& table, SheetSpec& sheet) {
    if (sheet.material.tempered > 0 && !is_isotropic(sheet.material))
        table.report("tempered", "needs an isotropic material");
    const bool has_unknown_preset = sheet.preset != nullptr && sheet.preset->name.empty();
    if (!has_unknown_preset) check_constants(table, sheet.material);
}

constexpr std::array<std::string_view, 2> calibrations{"third", "paper"};
constexpr std::string_view by_preset = "that of the preset; without one it is required";

constexpr std::array material_keys{
    table_key<axis_section, &SheetSpec::axis>("axis", "direction of the first material axis",
                                              {.otherwise = "`{ degrees = 0 }`"}),
    special_key("preset", Form::choice, "name of a material; other keys override its values",
                {.choices = preset_names, .otherwise = "none"}, read_preset),
    special_key("density", Form::number, "mass per volume",
                {.unit = "kg/m^3", .range = positive, .otherwise = by_preset}, read_density),
    special_key("thickness", Form::number | Form::table, "thickness: a number, or a map if it varies",
                {.unit = "m", .range = positive, .otherwise = by_preset}, read_thickness, inside_thickness),
    special_key("young", Form::number | Form::pair,
                "Young's modulus; `[Y0, Y1]`: along and across the material's axis",
                {.unit = "Pa", .range = positive, .otherwise = by_preset}, read_young),
    key<&SheetSpec::material, &Material::shear>(
        "shear", "shear modulus G01",
        {.unit = "Pa", .range = positive, .otherwise = "√(Y0 Y1) / (2 (1 + √(ν01 ν10)))"}),
    special_key("poisson", Form::number, "Poisson's ratio: between -1 and 0.5 if isotropic; otherwise ν01",
                {.otherwise = "that of the preset, or 0.3"}, read_poisson),
    special_key("young01", Form::number, "Y01 = ν01 Y1, instead of `poisson`",
                {.unit = "Pa", .excludes = {"poisson"}}, read_young01),
    key<&SheetSpec::material, &Material::calibration>(
        "calibration",
        "rigidity of the paper's hinges: a third of the plate's, or with `\"paper\"` all of it",
        {.choices = calibrations}),
    key<&SheetSpec::material, &Material::tempered>(
        "tempered", "compressive stress at the surfaces, balanced by tension inside, as in tempered glass",
        {.unit = "Pa", .range = not_negative}),
    special_key("yield", Form::number, "von Mises stress above which bending is plastic",
                {.unit = "Pa", .range = positive, .otherwise = "that of the preset"}, read_yield)};

}  // namespace

constinit const Section<SheetSpec> material_section{"Material of a sheet", material_keys, complete_material};

}  // namespace sherd
