// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/scene/read/selection.h"

#include <fmt/format.h>

#include <utility>

namespace sherd {
namespace {

void read_box(TomlTable& table, Selection& selection) {
    const std::vector<Eigen::VectorXd> corners = table.rows("box", "m", 2, 3);
    if (corners.size() == 2)
        selection.box.emplace(corners[0], corners[1]);
    else if (!corners.empty())
        table.report("box", "must be [lower corner, upper corner], two arrays of 3 numbers");
    if (selection.box && (selection.box->first.array() > selection.box->second.array()).any())
        table.report("box", "has a lower corner above its upper one: order them in x, y and z");
}

}  // namespace

Selection read_selection(TomlTable& table) {
    Selection selection;
    selection.where = table.where(table.has("group") ? "group" : "");
    selection.boundary = table.flag("boundary", false);
    if (table.has("box")) read_box(table, selection);
    if (table.has("group")) {
        selection.group = table.string("group", "the name of a group of the mesh file");
    }
    std::string given;
    for (const auto& [key, is_given] :
         {std::pair("box", table.has("box")), std::pair("group", table.has("group")),
          std::pair("boundary", selection.boundary)}) {
        if (!is_given) continue;
        if (!given.empty())
            table.report(key, fmt::format("conflicts with {}: write a table for each", given));
        given = key;
    }
    if (given.empty())
        table.report("", "holds nothing: give box = [[...], [...]], boundary = true or group = \"NAME\"");
    return selection;
}

}  // namespace sherd
