// SPDX-License-Identifier: GPL-3.0-or-later
#include "fracture/cracks/resolving_step.h"

#include <algorithm>
#include <map>

namespace sherd {
namespace {

struct EdgeLengths {
    double sum = 0;  ///< m
    double count = 0;
};

/// Lengths of all sides of faces, for each sheet that has a toughness, by the sheet's number.
std::map<Index, EdgeLengths> tough_edges(const BreakableShell& shell) {
    std::map<Index, EdgeLengths> lengths;
    for (std::size_t f = 0; f < shell.face_sheet().size(); ++f) {
        const Index sheet = shell.face_sheet()[f];
        if (!shell.toughness_of_sheet(sheet).given()) continue;
        const Matrix3d corners = columns(shell.mechanics().rest, shell.mechanics().triangles[f].vertices);
        for (int i = 0; i < 3; ++i) lengths[sheet].sum += (corners.col(i) - corners.col((i + 1) % 3)).norm();
        lengths[sheet].count += 3;
    }
    return lengths;
}

}  // namespace

std::optional<double> resolving_step(const BreakableShell& shell) {
    std::optional<double> least;
    for (const auto& [sheet, lengths] : tough_edges(shell)) {
        const double step = lengths.sum / lengths.count / shell.toughness_of_sheet(sheet).speed_limit;
        least = std::min(step, least.value_or(step));
    }
    return least;
}

}  // namespace sherd
