// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/scene/read/variants.h"

#include <algorithm>

#include "app/scene/read/plain_name.h"
#include "app/scene/toml/override.h"

namespace sherd {
std::vector<std::string> read_variant_names(TomlTable& root) {
    std::vector<std::string> names;
    for (TomlTable& variant : root.tables("variant")) {
        const std::string name =
            read_plain_name(variant, "variant", "becomes a part of a file's name", names);
        names.push_back(name);
    }
    return names;
}

void apply_variant(toml::table& scene, const std::string& name) {
    const toml::node_view<toml::node> variants = scene["variant"];
    std::vector<toml::table*> candidates;
    if (toml::table* only = variants.as_table()) candidates.push_back(only);
    if (toml::array* array = variants.as_array())
        for (toml::node& node : *array)
            if (toml::table* table = node.as_table()) candidates.push_back(table);
    toml::table changes;
    for (toml::table* candidate : candidates)
        if ((*candidate)["name"].value_or(std::string()) == name) changes = std::move(*candidate);
    changes.erase("name");
    scene.erase("variant");
    merge_keys(scene, std::move(changes));
}

}  // namespace sherd
