// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/scene/read/parts/place.h"

#include <fmt/format.h>

#include <array>
#include <numbers>

namespace sherd {
namespace {

constexpr std::array rotation_keys{
    direction_key<&Rotation::axis>("axis", "`[x, y, z]`, axis of the rotation", {.required = true}),
    key<&Rotation::degrees>("degrees", "angle, counterclockwise seen against the axis",
                            {.unit = "degrees", .required = true})};

std::vector<SectionText> inside_rotation() {
    return {text_of(rotation_section)};
}

void read_rotations(TomlTable& table, const KeyInfo& key, Eigen::Isometry3d& place) {
    for (TomlTable& inner : table.tables(key.name)) {
        Rotation rotation;
        read_section(inner, rotation_section, rotation);
        place.prerotate(rotation.turn().toRotationMatrix());
    }
}

void read_translation(TomlTable& table, const KeyInfo& key, Eigen::Isometry3d& place) {
    place.pretranslate(table.vector(key.name, key.rules.unit, Vector3d::Zero()));
}

constexpr std::array place_keys{
    special_key("rotate", Form::table | Form::tables,
                "rotation about the origin of the mesh; an array is applied in order", {.otherwise = "none"},
                read_rotations, inside_rotation),
    special_key("translate", Form::vector, "translation, after the rotations",
                {.unit = "m", .otherwise = "`[0, 0, 0]`"}, read_translation)};

void read_turn(TomlTable& table, const KeyInfo& key, MotionKey& motion) {
    auto inner = table.table(key.name);
    if (!inner) return;
    Rotation rotation;
    read_section(*inner, rotation_section, rotation);
    motion.axis = rotation.turn().axis();
    motion.angle = rotation.turn().angle();
}

constexpr std::array key_keys{
    key<&MotionKey::time>("time", "time, later than that of the previous key",
                          {.unit = "s", .range = not_negative, .required = true}),
    key<&MotionKey::translation>("translate", "displacement from where it was placed", {.unit = "m"}),
    special_key("rotate", Form::table,
                "rotation from where it was placed, about its centre, before the displacement",
                {.otherwise = "none"}, read_turn, inside_rotation)};

}  // namespace

constinit const Section<Rotation> rotation_section{"A rotation", rotation_keys};
constinit const Section<Eigen::Isometry3d> place_section{"Placement", place_keys};
constinit const Section<MotionKey> motion_key_section{"Position at a time", key_keys};

Eigen::AngleAxisd Rotation::turn() const {
    return {degrees * std::numbers::pi / 180, axis};
}

void read_direction(TomlTable& table, const KeyInfo& key, Vector3d& direction) {
    read_value(table, key, direction);
    if (direction.isZero(0)) table.report(key.name, "must not be zero: give a direction, such as [0, 0, 1]");
    // stableNormalized() is used, since the squares of tiny or huge components leave the range of double.
    direction = direction.stableNormalized();
}

void check_motion(TomlTable& table, const Motion& motion) {
    std::vector<TomlTable> tables = table.tables("keys");
    for (std::size_t i = 1; i < motion.keys.size(); ++i)
        if (motion.keys[i].time <= motion.keys[i - 1].time)
            tables[i].report("time", fmt::format("must be later than that of the previous key ({} s)",
                                                 motion.keys[i - 1].time));
    if (table.has("motion") && motion.keys.empty())
        table.report("motion", "needs keys = [{ time = 0 }, { time = 1, ... }]");
}

}  // namespace sherd
