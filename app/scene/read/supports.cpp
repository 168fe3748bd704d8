// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/scene/read/supports.h"

#include <algorithm>
#include <utility>

#include "app/scene/read/place.h"
#include "app/scene/read/selection.h"

namespace sherd {
namespace {

constexpr double at_rest = 1e-12;  // of the first key's rotation and way, m

std::array<bool, 3> read_free(TomlTable& table, bool clamps, bool moves) {
    constexpr std::array<std::string_view, 3> axes{"x", "y", "z"};
    std::array<bool, 3> free{};
    if (!table.has("free")) return free;
    const std::vector<std::string> names = table.choices("free", axes);
    for (std::size_t i = 0; i < axes.size(); ++i)
        free[i] = std::find(names.begin(), names.end(), axes[i]) != names.end();
    if (clamps)
        table.report("free", "is of pins only: a clamp holds its vertices in all directions");
    else if (moves)
        table.report("free", "conflicts with keys: a pin that moves holds its vertices in all directions");
    else if (names.size() == axes.size())
        table.report("free", "leaves nothing held: leave a direction out, or the pin");
    return free;
}

PinSpec read_pin(TomlTable& table, bool clamps) {
    PinSpec pin;
    pin.on = read_selection(table);
    read_motion(table, pin.motion);
    pin.free = read_free(table, clamps, !pin.motion.keys.empty());
    if (table.has("centre")) pin.centre = table.vector("centre", "m");
    if (pin.centre && pin.motion.keys.empty())
        table.report("centre", "needs keys = [{ time = 0 }, { time = 1, ... }]");
    if (!pin.motion.at(0).matrix().isIdentity(at_rest))
        table.report("keys", "must begin where the sheet is placed: without translate and rotate at first");
    table.finish();
    return pin;
}

SymmetrySpec read_symmetry(TomlTable& table) {
    SymmetrySpec plane;
    plane.where = table.where("");
    plane.point = table.vector("point", "m", Vector3d::Zero());
    plane.normal = read_direction(table, "normal");
    table.finish();
    return plane;
}

}  // namespace

void read_supports(TomlTable& table, SheetSpec& sheet) {
    for (const auto& [key, pins] : {std::pair("pin", &sheet.pins), std::pair("clamp", &sheet.clamps)})
        for (TomlTable& entry : table.tables(key)) pins->push_back(read_pin(entry, pins == &sheet.clamps));
    for (TomlTable& plane : table.tables("symmetry")) sheet.symmetries.push_back(read_symmetry(plane));
}

}  // namespace sherd
