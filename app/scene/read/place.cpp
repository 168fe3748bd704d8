// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/scene/read/place.h"

#include <fmt/format.h>

#include <array>
#include <numbers>
#include <utility>

namespace sherd {
namespace {

/// Axis and angle (rad) of a table { axis = [x, y, z], degrees = a }.
Eigen::AngleAxisd read_rotation(TomlTable& table) {
    const Vector3d axis = read_direction(table, "axis");
    const double degrees = table.number("degrees", "degrees", any_number);
    table.finish();
    return {degrees * std::numbers::pi / 180, axis};
}

MotionKey read_key(TomlTable& table) {
    MotionKey key;
    key.time = table.number("time", "s", not_negative);
    key.translation = table.vector("translate", "m", Vector3d::Zero());
    if (auto rotation = table.table("rotate")) {
        const Eigen::AngleAxisd turn = read_rotation(*rotation);
        key.axis = turn.axis();
        key.angle = turn.angle();
    }
    table.finish();
    return key;
}

}  // namespace

Vector3d read_direction(TomlTable& table, std::string_view key, std::optional<Vector3d> fallback) {
    const Vector3d direction = table.vector(key, "", std::move(fallback));
    if (direction.isZero(0)) table.report(key, "must not be zero: give a direction, such as [0, 0, 1]");
    // stableNormalized, since the squares of tiny or huge components leave the range of double.
    return direction.stableNormalized();
}

Eigen::Isometry3d read_place(TomlTable& table) {
    Eigen::Isometry3d place = Eigen::Isometry3d::Identity();
    for (TomlTable& rotation : table.tables("rotate"))
        place.prerotate(read_rotation(rotation).toRotationMatrix());
    place.pretranslate(table.vector("translate", "m", Vector3d::Zero()));
    table.finish();
    return place;
}

void read_motion(TomlTable& table, Motion& motion) {
    for (TomlTable& key : table.tables("keys")) {
        motion.keys.push_back(read_key(key));
        const std::size_t count = motion.keys.size();
        if (count > 1 && motion.keys[count - 1].time <= motion.keys[count - 2].time)
            key.report("time", fmt::format("must be later than that of the key before it ({} s)",
                                           motion.keys[count - 2].time));
    }
    if (!table.has("motion")) return;
    constexpr std::array<std::string_view, 2> kinds{"smooth", "linear"};
    motion.smooth = table.choice("motion", kinds) != "linear";
    if (motion.keys.empty()) table.report("motion", "needs keys = [{ time = 0 }, { time = 1, ... }]");
}

}  // namespace sherd
