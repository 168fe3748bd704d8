// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/scene/keys/key.h"
#include "core/motion.h"

namespace sherd {

/// Reads a direction, and makes it a unit vector. Reports a direction that is zero.
void read_direction(TomlTable& table, const KeyInfo& key, Vector3d& direction);

/// `rotate = { axis = [x, y, z], degrees = a }`.
struct Rotation {
    Vector3d axis = Vector3d::UnitZ();
    double degrees = 0;

    Eigen::AngleAxisd turn() const;
};
extern const Section<Rotation> rotation_section;

extern const Section<Eigen::Isometry3d> place_section;
extern const Section<MotionKey> motion_key_section;

/// A key of a direction, which is read into the member at the end of `path`, a chain of pointers to members
/// (keys::Path).
template <auto... path>
constexpr auto direction_key(std::string_view name, std::string_view sentence, const KeyRules& rules = {}) {
    auto result = key<path...>(name, sentence, rules);
    using Struct = typename keys::Path<path...>::Struct;
    result.read = [](TomlTable& table, const KeyInfo& info, Struct& into) {
        read_direction(table, info, keys::at<path...>(into));
    };
    return result;
}

inline constexpr std::array<std::string_view, 2> interpolations{"smooth", "linear"};

/// Keys of a prescribed motion.
inline constexpr std::array motion_keys{
    table_key<motion_key_section, &Motion::keys>(
        "keys", "positions at given times, relative to where it was placed", {.otherwise = "no motion"}),
    key<&Motion::smooth>("motion", "motion between two keys: from rest to rest, or at constant speed",
                         {.choices = interpolations})};

/// Reports keys of a motion whose times do not increase, and an interpolation of a motion that has no keys.
void check_motion(TomlTable& table, const Motion& motion);

}  // namespace sherd
