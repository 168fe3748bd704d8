// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>

#include "core/tips/near_tip_fields.h"

namespace sherd {

/// A tip of a crack in a sheet that has a toughness. Places and directions are those of the rest shape.
struct GrowingTip {
    Index vertex = 0;
    Vector3d on_path = Vector3d::Zero();     ///< m, point of the exact path for which the vertex stands
    Vector3d direction = Vector3d::UnitX();  ///< unit vector of the path so far, in the tangent plane
    double ready = 0;                        ///< s, earliest time of propagation, by the speed limit
    Index behind = -1;                       ///< edge that failed last and must have opened first
    Index number = 0;                        ///< unique among all tips so far
    Index other_branch = -1;                 ///< number of the other tip of the last branching; -1: none
    double release = 0;                      ///< mean of G / G_c over the last edges
    double stride = 0;                       ///< m, length of its last edge along the path
    double since = 0;                        ///< s, time at which its last edge began
    double before = 0;                       ///< m/s, speed along the edge before the last

    /// Speed, m/s, at a time (s): as along the edge before, until the last edge takes longer than at that
    /// speed.
    double speed(double time) const {
        return stride > 0 ? stride / std::max(time - since, stride / before) : 0;
    }
};

/// Load on a tip.
struct TipLoad {
    double intensity = 0;                    ///< K, Pa m^0.5: the tip propagates if it exceeds the toughness
    Vector3d direction = Vector3d::UnitX();  ///< unit vector of propagation, in the tangent plane
    double residual = 0;                     ///< share of residual stress in the energy released
    bool by_energy = false;                  ///< whether the intensity follows from the energy released
    ModePair membrane;                       ///< K_I, K_II, Pa m^0.5
    ModePair plate;                          ///< k_1, k_2, Pa m^0.5
};

}  // namespace sherd
