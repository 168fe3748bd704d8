// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/scene/read/material.h"

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "app/scene/read/map_source.h"

namespace sherd {
namespace {

constexpr Range poisson_range{[](double x) { return x > -1 && x < 0.5; }, "a number between -1 and 0.5"};

/// Young's moduli, shear modulus and Poisson's ratio.
void read_constants(TomlTable& table, const Material* preset, Material& material) {
    if (table.is_array("young")) {
        const Eigen::Vector2d young = table.pair("young", "Pa", positive);
        material.young = young[0];
        material.young1 = young[1];
    } else if (preset && !table.has("young")) {
        material.young = preset->young;
        material.young1 = preset->young1;
        material.shear = preset->shear;
    } else {
        material.young = table.number("young", "Pa", positive);
    }
    if (table.has("shear")) material.shear = table.number("shear", "Pa", positive);
    const bool has_poisson = table.has("poisson");
    if (table.has("young01")) {
        if (has_poisson) table.report("young01", "conflicts with poisson: give one of them");
        material.poisson =
            table.number("young01", "Pa", any_number) / material.young1.value_or(material.young);
    } else {
        material.poisson = table.number("poisson", "", is_isotropic(material) ? poisson_range : any_number,
                                        preset ? preset->poisson : 0.3);
    }
}

void check_constants(TomlTable& table, const Material& material) {
    const Orthotropy m = elastic_constants(material);
    // What is not a number is a problem already.
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

}  // namespace

MaterialAxis read_axis(TomlTable& material, const std::filesystem::path& directory) {
    MaterialAxis axis;
    axis.where = material.where("axis");
    std::optional<TomlTable> table = material.table("axis");
    if (!table) return axis;
    const bool direction = table->has("direction"), degrees = table->has("degrees"),
               texture = table->has("texture"), field = table->has("field");
    if ((direction || degrees) + texture + field != 1) {
        table->report("", "needs direction, degrees or both, or texture, or field");
        table->finish();
        return axis;
    }
    if (direction || degrees) {
        AxisDirection given;
        if (direction) given.direction = table->vector("direction", "").stableNormalized();
        if (given.direction.isZero(0))
            table->report("direction", "must not be zero: give one such as [1, 0, 0]");
        if (degrees) given.degrees = table->number("degrees", "degrees", any_number);
        axis.kind = given;
        if (direction) axis.where = table->where("direction");
    } else if (field) {
        if (!table->flag("field", true)) table->report("field", "must be true, or left out");
        axis.kind = AxisField{};
        axis.where = table->where("field");
    } else {
        AxisTexture image{directory / table->string("texture", "the name of a PNG file")};
        if (table->has("encoding")) {
            constexpr std::array<std::string_view, 2> names{"hue", "vector"};
            image.encoding =
                table->choice("encoding", names) == "vector" ? AxisEncoding::vector : AxisEncoding::hue;
        }
        axis.kind = image;
        axis.where = table->where("texture");
    }
    table->finish();
    return axis;
}

std::optional<ThicknessMap> read_thickness_map(TomlTable& material, const std::filesystem::path& directory) {
    if (!material.is_table("thickness")) return std::nullopt;
    TomlTable table = *material.table("thickness");
    ThicknessMap map;
    map.source = read_map_source(table, directory, map.where);
    map.scale = table.number("scale", "m", positive, map.scale);
    if (table.has("range")) {
        map.range = table.pair("range", "m", positive, false);
        if (table.has("scale")) table.report("scale", "conflicts with range: give one of them");
    } else if (std::holds_alternative<MapTexture>(map.source) && !table.has("scale")) {
        table.report("", "needs range, the thickness (m) of black and of white");
    }
    table.finish();
    return map;
}

const MaterialPreset* read_preset(TomlTable& material) {
    if (!material.has("preset")) return nullptr;
    std::vector<std::string_view> names;
    for (const MaterialPreset& known : material_presets()) names.push_back(known.name);
    const std::string name = material.choice("preset", names);
    for (const MaterialPreset& known : material_presets())
        if (known.name == name) return &known;
    // A preset that is not known is one mistake, not four.
    static constexpr MaterialPreset unknown{"", {}, FracturePreset{}};
    return &unknown;
}

Material read_material(TomlTable& table, const MaterialPreset* chosen, bool has_map) {
    const Material* preset = chosen ? &chosen->material : nullptr;
    const auto from_preset = [&](double Material::*member) {
        return preset ? std::optional<double>(preset->*member) : std::nullopt;
    };
    Material material;
    material.density = table.number("density", "kg/m^3", positive, from_preset(&Material::density));
    if (!has_map)
        material.thickness = table.number("thickness", "m", positive, from_preset(&Material::thickness));
    read_constants(table, preset, material);
    if (table.has("calibration")) {
        constexpr std::array<std::string_view, 2> names{"third", "paper"};
        if (table.choice("calibration", names) == "paper") material.calibration = Calibration::paper;
    }
    material.tempered = table.number("tempered", "Pa", not_negative, 0.0);
    if (material.tempered > 0 && !is_isotropic(material))
        table.report("tempered", "needs a material that is alike in all directions");
    if (table.has("yield"))
        material.yield = table.number("yield", "Pa", positive);
    else if (preset)
        material.yield = preset->yield;
    const bool has_unknown_preset = chosen && chosen->name.empty();
    if (!has_unknown_preset) check_constants(table, material);
    table.finish();
    return material;
}

}  // namespace sherd
