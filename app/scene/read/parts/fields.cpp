// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/scene/read/parts/fields.h"

#include <algorithm>

namespace sherd {

FaceFieldChoice chosen_fields(const std::vector<std::string>& names) {
    const auto has = [&](const char* name) { return std::ranges::find(names, name) != names.end(); };
    return {
        .stress = has("stress"), .curvature = has("curvature"), .membrane_strain = has("membrane_strain")};
}

}  // namespace sherd
