// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshops/face_groups.h"

#include <algorithm>

namespace sherd {

std::vector<std::string> group_names(const Mesh& mesh) {
    const auto [groups, exists] = find_property(mesh, attribute::groups);
    std::vector<std::string> names;
    if (!exists) return names;
    GroupNames last;
    for (const Face face : mesh.faces()) {
        // Successive faces with the same groups have a pointer to the same list, which is added once.
        if (groups[face] && groups[face] != last)
            names.insert(names.end(), groups[face]->begin(), groups[face]->end());
        last = groups[face];
    }
    std::sort(names.begin(), names.end());
    names.erase(std::unique(names.begin(), names.end()), names.end());
    return names;
}

bool is_in_group(const Mesh& mesh, Vertex vertex, std::string_view group) {
    const auto [groups, exists] = find_property(mesh, attribute::groups);
    if (!exists) return false;
    for (const Face face : mesh.faces_around_target(mesh.halfedge(vertex))) {
        if (face == Mesh::null_face() || !groups[face]) continue;
        const std::vector<std::string>& names = *groups[face];
        if (std::find(names.begin(), names.end(), group) != names.end()) return true;
    }
    return false;
}

GroupNames one_word_names(const GroupNames& names) {
    if (!names) return names;
    std::vector<std::string> words = *names;
    for (std::string& word : words) std::ranges::replace(word, ' ', '_');
    return std::make_shared<const std::vector<std::string>>(std::move(words));
}

}  // namespace sherd
