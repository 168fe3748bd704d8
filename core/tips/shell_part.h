// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/bending/coupled_bending.h"

namespace sherd {

/// Some faces of a shell as a shell of their own, with the data that coupled hinges need: corners,
/// elasticity, and folds that join two of the faces.
struct ShellPart {
    Shell shell;
    std::vector<MirrorHinge> mirrors;
    std::vector<Index> vertices;  ///< [V] numbers in the whole shell, ascending
    std::vector<Index> faces;     ///< [F] numbers in the whole shell, ascending
    std::vector<Index> folds;     ///< [mirrors + E] numbers in the whole shell, mirrors first
};

/// The part that has these folds, and all faces on either side of them.
ShellPart shell_part(const Shell& shell, const CoupledBending& bending, std::span<const Index> folds);

/// Sets the rest positions of the part, [3, V] m: areas and frames follow, and each face's elasticity keeps
/// its direction in the sheet.
void move_rest(ShellPart& part, const Positions& rest);

}  // namespace sherd
