// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/scene/read/parts/selection.h"

#include <fmt/format.h>

namespace sherd {

void read_box(TomlTable& table, const KeyInfo& key, Selection& selection) {
    if (!table.has(key.name)) return;
    const std::vector<Eigen::VectorXd> corners =
        table.rows(key.name, key.rules.unit, key.rules.least_rows, key.rules.columns, key.rules.most_rows);
    if (corners.empty()) return;
    selection.box.emplace(corners[0], corners[1]);
    if ((selection.box->first.array() > selection.box->second.array()).any())
        table.report(key.name, "has a lower corner above its upper one: order them in x, y and z");
}

bool selects(TomlTable& table) {
    return table.has("box") || table.has("boundary") || table.has("group");
}

void complete_selection(TomlTable& table, Selection& selection) {
    const bool has_box = table.has("box"), has_group = table.has("group");
    selection.where = table.where(has_group ? "group" : "");
    if (selection.boundary && (has_box || has_group))
        table.report("boundary",
                     fmt::format("conflicts with {}: write a table for each", has_box ? "box" : "group"));
    if (!selection.boundary && !has_box && !has_group)
        table.report("", "holds nothing: give box = [[...], [...]], boundary = true or group = \"NAME\"");
}

}  // namespace sherd
