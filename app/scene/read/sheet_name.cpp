// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/scene/read/sheet_name.h"

#include <fmt/format.h>

#include <algorithm>

namespace sherd {

std::string read_sheet_name(TomlTable& table, const Scene& scene) {
    if (!table.has("sheet")) return {};
    std::string name = table.string("sheet", "the name of a sheet");
    const bool known = std::any_of(scene.sheets.begin(), scene.sheets.end(),
                                   [&](const SheetSpec& sheet) { return sheet.name == name; });
    if (!name.empty() && !known)
        table.report("sheet", fmt::format("names no sheet of this scene: there is no [sheet.{}]", name));
    return name;
}

}  // namespace sherd
