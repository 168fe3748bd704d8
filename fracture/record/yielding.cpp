// SPDX-License-Identifier: GPL-3.0-or-later
#include "fracture/record/yielding.h"

#include <algorithm>
#include <cmath>

#include "core/shell/face_fields.h"

namespace sherd {

double von_mises(const Vector3d& stress) {
    return std::sqrt(stress[0] * stress[0] - stress[0] * stress[1] + stress[1] * stress[1] +
                     3 * stress[2] * stress[2]);
}

YieldPeak yield_peak(const BreakableShell& shell, const FaceStrains& strains) {
    const Shell& mechanics = shell.mechanics();
    YieldPeak peak;
    if (!shell.yields()) return peak;
    for (std::size_t f = 0; f < mechanics.triangles.size(); ++f) {
        const auto face = static_cast<Index>(f);
        const double yield = shell.yield_of_sheet(mechanics.face_sheet[f]);
        if (!(yield > 0)) continue;
        const FaceState state =
            face_state(mechanics, face, strains.membrane.col(face), strains.curvature.col(face));
        const double ratio = std::max(von_mises(state.stress_top), von_mises(state.stress_bottom)) / yield;
        if (ratio > peak.ratio) peak = {ratio, face_place(mechanics, face)};
    }
    return peak;
}

}  // namespace sherd
