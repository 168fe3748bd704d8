// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/scene/read/place.h"

#include <fmt/format.h>

#include <array>
#include <numbers>

namespace sherd {
namespace {

constexpr std::array rotation_keys{
    direction_key<&Rotation::axis>("axis", "`[x, y, z]`, about which it turns", {.required = true}),
    key<&Rotation::degrees>("degrees", "by how much, counterclockwise seen against the axis",
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
                "turns it about the origin of the mesh; an array is applied in order", {.otherwise = "none"},
                read_rotations, inside_rotation),
    special_key("translate", Form::vector, "moves it after the rotations",
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
    key<&MotionKey::time>("time", "later than that of the key before",
                          {.unit = "s", .range = not_negative, .required = true}),
    key<&MotionKey::translation>("translate", "by how much it has moved", {.unit = "m"}),
    special_key("rotate", Form::table, "by how much it has turned, before it is moved, about its centre",
                {.otherwise = "none"}, read_turn, inside_rotation)};

}  // namespace

constinit const Section<Rotation> rotation_section{"A rotation", rotation_keys};
constinit const Section<Eigen::Isometry3d> place_section{"Where it is placed", place_keys};
constinit const Section<MotionKey> motion_key_section{"Where it is at a time", key_keys};

Eigen::AngleAxisd Rotation::turn() const {
    return {degrees * std::numbers::pi / 180, axis};
}

void read_direction(TomlTable& table, const KeyInfo& key, Vector3d& direction) {
    read_value(table, key, direction);
    if (direction.isZero(0)) table.report(key.name, "must not be zero: give a direction, such as [0, 0, 1]");
    // stableNormalized, since the squares of tiny or huge components leave the range of double.
    direction = direction.stableNormalized();
}

void check_motion(TomlTable& table, const Motion& motion) {
    std::vector<TomlTable> tables = table.tables("keys");
    for (std::size_t i = 1; i < motion.keys.size(); ++i)
        if (motion.keys[i].time <= motion.keys[i - 1].time)
            tables[i].report("time", fmt::format("must be later than that of the key before it ({} s)",
                                                 motion.keys[i - 1].time));
    if (table.has("motion") && motion.keys.empty())
        table.report("motion", "needs keys = [{ time = 0 }, { time = 1, ... }]");
}

}  // namespace sherd
