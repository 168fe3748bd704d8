// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/scene/read/fields.h"

#include <algorithm>

namespace sherd {

FaceFieldChoice chosen_fields(const std::vector<std::string>& names) {
    const auto has = [&](const char* name) { return std::ranges::find(names, name) != names.end(); };
    return {
        .stress = has("stress"), .curvature = has("curvature"), .membrane_strain = has("membrane_strain")};
}

FaceFieldChoice read_fields(TomlTable& output) {
    if (!output.has("fields")) return {};
    if (output.is_array("fields") || output.is_string("fields"))
        return chosen_fields(output.choices("fields", field_names));
    const bool all = output.flag("fields", false);
    return {.stress = all, .curvature = all, .membrane_strain = all};
}

}  // namespace sherd
