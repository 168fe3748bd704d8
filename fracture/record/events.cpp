// SPDX-License-Identifier: GPL-3.0-or-later
#include "fracture/record/events.h"

namespace sherd {

void set_time(CrackEvents& events, std::int64_t step, double time) {
    visit_kinds([&](auto kind) {
        auto& of_kind = events.*kind;
        for (auto event = of_kind.rbegin(); event != of_kind.rend() && event->step == step; ++event)
            event->time = time;
    });
}

void append_insertions(const TopologyChange& change, std::int64_t step, CrackEvents& events) {
    for (const WithParents<Vertex>& vertex : change.vertices) {
        const auto created = static_cast<Index>(vertex.element);
        if (vertex.is_copy()) {
            events.splits.push_back({0, step, static_cast<Index>(vertex.parent()), created});
            continue;
        }
        VertexInsertion insertion{0, step, created, {}, {}};
        insertion.parents.fill(static_cast<Index>(vertex.parents.front().element));
        for (std::size_t i = 0; i < vertex.parents.size(); ++i) {
            insertion.parents[i] = static_cast<Index>(vertex.parents[i].element);
            insertion.weights[i] = vertex.parents[i].weight;
        }
        events.vertex_insertions.push_back(insertion);
    }
    for (const WithParents<Face>& face : change.faces)
        events.face_insertions.push_back(
            {0, step, static_cast<Index>(face.element), static_cast<Index>(face.parents.front().element)});
}

void append(CrackEvents& events, const CrackEvents& later) {
    visit_kinds([&](auto kind) {
        (events.*kind).insert((events.*kind).end(), (later.*kind).begin(), (later.*kind).end());
    });
}

}  // namespace sherd
