// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/scene/read/gauges.h"

#include <algorithm>
#include <array>

#include "app/scene/read/fields.h"
#include "app/scene/read/plain_name.h"
#include "app/scene/read/sheet_name.h"

namespace sherd {

void read_gauges(TomlTable& root, Scene& scene) {
    std::vector<std::string> names;
    for (TomlTable& table : root.tables("gauge")) {
        GaugeSpec gauge;
        gauge.where = table.where("at");
        gauge.name = read_plain_name(table, "gauge", "names a group of the recording", names);
        names.push_back(gauge.name);
        gauge.at = table.vector("at", "m");
        gauge.sheet = read_sheet_name(table, scene);
        if (table.has("record")) {
            constexpr std::array<std::string_view, 4> names_of_all{"displacement", "stress", "curvature",
                                                                   "membrane_strain"};
            const std::vector<std::string> wanted = table.choices("record", names_of_all);
            gauge.displacement = std::ranges::find(wanted, "displacement") != wanted.end();
            gauge.fields = chosen_fields(wanted);
        }
        table.finish();
        scene.gauges.push_back(gauge);
    }
}

}  // namespace sherd
