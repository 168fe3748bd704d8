// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/scene/keys/key.h"

#include <fmt/format.h>

namespace sherd {

void report_conflicts(TomlTable& table, const KeyInfo& key) {
    for (const std::string_view other : key.rules.excludes)
        if (!other.empty() && table.has(key.name) && table.has(other))
            table.report(key.name, fmt::format("conflicts with {}: give one of them", other));
}

}  // namespace sherd
