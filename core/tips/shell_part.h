// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/bending/coupled_bending.h"

namespace sherd {

/// A few faces of a shell as a shell of their own, with what coupled hinges need of it: corners, elasticity,
/// and those of some folds that join two of the faces.
struct ShellPart {
    Shell shell;
    std::vector<MirrorHinge> mirrors;
    std::vector<Index> vertices;  ///< [V] of the whole shell, by ascending number
    std::vector<Index> faces;     ///< [F] of the whole shell, by ascending number
    std::vector<Index> folds;     ///< [mirrors + E] of the whole shell, mirrors first
};

/// The part that has these folds, and all faces on either side of them.
ShellPart shell_part(const Shell& shell, const CoupledBending& bending, std::span<const Index> folds);

/// Puts the rest positions of the part elsewhere, [3, V] m: areas and frames follow, and each face's
/// elasticity keeps its direction in the sheet.
void move_rest(ShellPart& part, const Positions& rest);

}  // namespace sherd
