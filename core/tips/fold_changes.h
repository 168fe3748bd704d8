// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <numbers>

#include "core/bending/coupled_bending.h"

namespace sherd {

/// Changes of the angles of some folds from their rest angles, rad, [folds of the shell]; zero for other
/// folds.
inline VectorXd changes_of(const CoupledBending& bending, const Positions& x, std::span<const Index> folds) {
    VectorXd changes = bending.all_folds().angles(x, folds);
    for (const Index fold : folds)
        changes[fold] =
            std::remainder(changes[fold] - bending.all_folds().rest_angle(fold), 2 * std::numbers::pi);
    return changes;
}

}  // namespace sherd
