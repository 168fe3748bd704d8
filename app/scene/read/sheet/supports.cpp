// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/scene/read/sheet/supports.h"

#include <algorithm>

#include "app/scene/read/parts/place.h"
#include "app/scene/read/parts/selection.h"

namespace sherd {
namespace {

constexpr double at_rest = 1e-12;  // tolerance of the first key's rotation, and of its translation, m
constexpr std::array<std::string_view, 3> axes{"x", "y", "z"};

void read_free(TomlTable& table, const KeyInfo& key, PinSpec& pin) {
    if (!table.has(key.name)) return;
    const std::vector<std::string> names = table.choices(key.name, key.rules.choices);
    for (std::size_t i = 0; i < axes.size(); ++i)
        pin.free[i] = std::ranges::find(names, axes[i]) != names.end();
}

void complete_support(TomlTable& table, PinSpec& pin) {
    complete_selection(table, pin.on);
    check_motion(table, pin.motion);
    if (pin.centre && pin.motion.keys.empty())
        table.report("centre", "needs keys = [{ time = 0 }, { time = 1, ... }]");
    if (!pin.motion.at(0).matrix().isIdentity(at_rest))
        table.report("keys",
                     "must begin where the sheet is placed: the first key must not translate or rotate");
}

void complete_pin(TomlTable& table, PinSpec& pin) {
    complete_support(table, pin);
    if (!pin.holds_all_directions() && !pin.motion.keys.empty())
        table.report("free", "conflicts with keys: a pin that moves holds its vertices in all directions");
    else if (pin.free == std::array{true, true, true})
        table.report("free", "holds nothing: remove a direction, or the pin");
}

void refuse_free(TomlTable& table, const KeyInfo& key, PinSpec& /*clamp*/) {
    if (table.has(key.name))
        table.report(key.name, "is for pins only: a clamp holds its vertices in all directions");
}

constexpr std::array centre_key{
    key<&PinSpec::centre>("centre", "`[x, y, z]`, centre of the rotations in `keys`",
                          {.unit = "m", .otherwise = "the middle of the bounding box of its vertices"})};
constexpr auto support_keys =
    joined(embedded<selection_keys, &PinSpec::on>(), embedded<motion_keys, &PinSpec::motion>(), centre_key);
constexpr auto pin_keys = joined(
    support_keys, std::array{special_key("free", Form::names, "directions in which its vertices stay free",
                                         {.choices = axes, .otherwise = "none"}, read_free)});
constexpr auto clamp_keys =
    joined(support_keys, std::array{special_key("free", Form{}, "", {}, refuse_free)});

void complete_symmetry(TomlTable& table, SymmetrySpec& plane) {
    plane.where = table.where("");
}

constexpr std::array symmetry_keys{
    key<&SymmetrySpec::point>("point", "a point of the plane", {.unit = "m"}),
    direction_key<&SymmetrySpec::normal>("normal", "`[x, y, z]`, normal of the plane", {.required = true})};

}  // namespace

constinit const Section<PinSpec> pin_section{"A pin: vertices that are held", pin_keys, complete_pin};
constinit const Section<PinSpec> clamp_section{"A clamp: vertices that are held, with the sheet's tangent",
                                               clamp_keys, complete_support};
constinit const Section<SymmetrySpec> symmetry_section{
    "A symmetry plane, behind which the sheet continues as its mirror image", symmetry_keys,
    complete_symmetry};

}  // namespace sherd
