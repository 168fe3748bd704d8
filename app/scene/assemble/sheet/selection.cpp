// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/scene/assemble/sheet/selection.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "app/messages/nearest_name.h"
#include "meshops/error.h"
#include "meshops/face_groups.h"
#include "meshops/mesh_measures.h"

namespace sherd {

bool selects(const Selection& selection, const Mesh& mesh, Vertex v) {
    if (selection.boundary) return mesh.is_border(v);
    if (!selection.group.empty()) return is_in_group(mesh, v, selection.group);
    if (!selection.box) return true;
    const Vector3d p = position(mesh, v);
    return (p.array() >= selection.box->first.array()).all() &&
           (p.array() <= selection.box->second.array()).all();
}

void check_group(const Selection& selection, const std::vector<std::string>& known) {
    if (selection.group.empty() || std::find(known.begin(), known.end(), selection.group) != known.end())
        return;
    if (known.empty())
        throw Error(fmt::format("{}: the mesh has no groups; they are `g` or `o` lines of an OBJ file",
                                selection.where));
    const std::string nearest = nearest_name(selection.group, known);
    const std::string hint = nearest.empty() ? fmt::format("it has {}", fmt::join(known, ", "))
                                             : fmt::format("did you mean '{}'?", nearest);
    throw Error(fmt::format("{}: the mesh has no group '{}'; {}", selection.where, selection.group, hint));
}

std::vector<char> selected_vertices(const Selection& selection, const std::string& sheet, const Scene& scene,
                                    const std::vector<SheetInput>& inputs) {
    std::vector<char> selected;
    std::vector<std::string> known;
    for (std::size_t i = 0; i < inputs.size(); ++i) {
        if (!sheet.empty() && scene.sheets[i].name != sheet) continue;
        const std::vector<std::string> names = group_names(inputs[i].mesh);
        known.insert(known.end(), names.begin(), names.end());
    }
    check_group(selection, known);
    for (std::size_t i = 0; i < inputs.size(); ++i)
        for (const Vertex v : inputs[i].mesh.vertices())
            selected.push_back((sheet.empty() || scene.sheets[i].name == sheet) &&
                               selects(selection, inputs[i].mesh, v));
    return selected;
}

}  // namespace sherd
