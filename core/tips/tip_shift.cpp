// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tips/tip_shift.h"

#include <algorithm>

namespace sherd {

Index TipShift::find(Index vertex) const {
    const auto at = std::ranges::lower_bound(vertices, vertex);
    return at == vertices.end() || *at != vertex ? -1 : static_cast<Index>(at - vertices.begin());
}

TipShift tip_shift(const Shell& shell, const VertexFaces& around, const CrackTip& tip, int rings) {
    TipShift shift{tip.vertex, {}, {}};
    for (int ring = 0; ring <= rings && ring < static_cast<int>(tip.rings.size()); ++ring)
        shift.vertices.insert(shift.vertices.end(), tip.rings[ring].begin(), tip.rings[ring].end());
    std::ranges::sort(shift.vertices);
    for (const Index vertex : shift.vertices)
        shift.by.emplace_back(smallest_turn(tip.normal, rest_normal(shell, around, vertex)) * tip.axes());
    return shift;
}

}  // namespace sherd
