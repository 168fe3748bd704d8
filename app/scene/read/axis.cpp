// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/scene/read/axis.h"

namespace sherd {
namespace {

/// Returns the axis as a direction, and makes it one if it is of another kind.
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

}  // namespace

constinit const Section<MaterialAxis> axis_section{"Direction of the first material axis", axis_keys,
                                                   complete_axis};

}  // namespace sherd
