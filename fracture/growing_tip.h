// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>

#include "core/tips/near_tip_fields.h"

namespace sherd {

/// A tip of a crack in a sheet that has a toughness. All of it is of the rest shape.
struct GrowingTip {
    Index vertex = 0;
    Vector3d on_path = Vector3d::Zero();     ///< m, the point of the true path that the vertex stands for
    Vector3d direction = Vector3d::UnitX();  ///< in which the crack came, a unit vector in the tangent plane
    double ready = 0;                        ///< s, before which the speed limit does not let it go on
    Index behind = -1;                       ///< the edge that failed last, which must have opened before
    Index number = 0;                        ///< of all tips that there have been
    Index twin = -1;                         ///< number of the other tip of the last branching; -1: none
    double release = 0;                      ///< mean of G / G_c over the last edges
    double stride = 0;                       ///< m, of its last edge along the path
    double since = 0;                        ///< s, from which on the last edge went
    double before = 0;                       ///< m/s, its speed along the edge before

    /// m/s, at a time (s): as along the edge before, until the next one is late.
    double speed(double time) const {
        return stride > 0 ? stride / std::max(time - since, stride / before) : 0;
    }
};

/// What a tip bears.
struct TipLoad {
    double intensity = 0;                    ///< K, Pa m^0.5: it goes on where this exceeds the toughness
    Vector3d direction = Vector3d::UnitX();  ///< in which it then goes on, a unit vector in the tangent plane
    double residual = 0;                     ///< share of residual stress in the energy released
    bool by_energy = false;                  ///< whether the intensity is that of the energy released
    ModePair membrane;                       ///< K_I, K_II, Pa m^0.5
    ModePair plate;                          ///< k_1, k_2, Pa m^0.5
};

}  // namespace sherd
