// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/scene/read/parts/sheet_name.h"

#include <fmt/format.h>

#include <algorithm>

namespace sherd {

void check_sheet_name(TomlTable& table, const Scene& scene) {
    if (!table.is_string("sheet")) return;
    const std::string name = table.string("sheet", "");
    const bool known =
        std::ranges::any_of(scene.sheets, [&](const SheetSpec& sheet) { return sheet.name == name; });
    if (!name.empty() && !known)
        table.report("sheet", fmt::format("names no sheet of this scene: there is no [sheet.{}]", name));
}

}  // namespace sherd
