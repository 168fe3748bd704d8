// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/measures/fragments/fragment_info.h"

namespace sherd {

std::vector<FragmentInfo> fragments_of(const Snapshot& frame) {
    VectorXd vertex_area = VectorXd::Zero(frame.mass.size());
    for (std::size_t f = 0; f < frame.faces.size(); ++f)
        for (const Index v : frame.faces[f]) vertex_area[v] += frame.rest.area[f];
    std::vector<FragmentInfo> fragments;
    for (std::size_t f = 0; f < frame.faces.size(); ++f) {
        const Index id = frame.face_fragment[f];
        while (fragments.size() <= static_cast<std::size_t>(id))
            fragments.push_back({.id = static_cast<Index>(fragments.size())});
        FragmentInfo& fragment = fragments[id];
        ++fragment.faces;
        fragment.area += frame.rest.area[f];
        for (const Index v : frame.faces[f])
            fragment.mass += frame.mass[v] * frame.rest.area[f] / vertex_area[v];
    }
    return fragments;
}

}  // namespace sherd
