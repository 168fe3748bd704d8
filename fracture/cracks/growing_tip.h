// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>

#include "core/tips/near_tip_fields.h"

namespace sherd {

/// A tip of a crack in a sheet that has a toughness. Points and directions refer to the rest shape.
struct GrowingTip {
    Index vertex = 0;
    Vector3d on_path = Vector3d::Zero();     ///< m, point of the exact path beside the vertex
    Vector3d direction = Vector3d::UnitX();  ///< unit vector along the path at the tip, in the tangent plane
    double ready = 0;                        ///< s, the speed limit forbids propagation before this time
    Index behind = -1;                       ///< last edge that failed; must open before it propagates
    Index number = 0;                        ///< unique among all tips so far
    Index other_branch = -1;                 ///< number of the other tip of its last branching; -1: none
    double release = 0;                      ///< mean of G / G_c over the last edges
    double stride = 0;                       ///< m, length of its last edge along the path; 0: there is none
                                             ///< yet
    double since = 0;                        ///< s, time at which it began its last edge
    double before = 0;                       ///< m/s, its speed on the edge before the last one

    /// Returns the speed, m/s, at `time` (s): the speed on the edge before the last one, until the last edge
    /// has taken longer than it would at that speed; from then on the length of the last edge over the time
    /// spent on it. Returns 0 if the tip has not propagated yet.
    double speed(double time) const {
        return stride > 0 ? stride / std::max(time - since, stride / before) : 0;
    }
};

/// Load on a tip.
struct TipLoad {
    double intensity = 0;                    ///< K, Pa m^0.5: the tip propagates if it exceeds the toughness
    Vector3d direction = Vector3d::UnitX();  ///< unit vector of propagation, in the tangent plane
    double residual = 0;                     ///< share of the energy released that comes from residual stress
    bool by_energy = false;                  ///< whether the intensity follows from the energy released
    ModePair membrane;                       ///< K_I and K_II of the membrane, Pa m^0.5
    ModePair plate;                          ///< k_1 and k_2 of bending, Pa m^0.5
};

}  // namespace sherd
