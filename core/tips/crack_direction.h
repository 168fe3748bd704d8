// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tips/near_tip_fields.h"

namespace sherd {

// Direction in which a crack propagates: at right angles to the largest hoop stress around its tip (Erdogan
// and Sih, On the crack extension in plates under plane loading and transverse shear, 1963). Angles are in
// rad from the crack's own direction, counterclockwise as seen against the normal.

/// Angle for the membrane alone: 2 atan((K_I - sqrt(K_I^2 + 8 K_II^2)) / (4 K_II)), between -180 and 180
/// degrees. If K_II is zero and K_I positive, it is 0. If K_I is not negative, it is between -70.5 and 70.5
/// degrees.
double hoop_angle(const ModePair& membrane);

/// The direction of the largest hoop stress at the two surfaces.
struct HoopDirection {
    double angle = 0;      ///< rad
    double intensity = 0;  ///< Pa m^0.5: hoop stress times sqrt(2 pi r)
    bool top = false;      ///< whether it is at the surface to which the normal points (FaceState)
};

/// Finds the direction for membrane and bending together by a search. If the maxima at the two surfaces are
/// equal, it takes the bottom.
HoopDirection hoop_direction(const PlaneStress& material, const ModePair& membrane, const ModePair& plate);

}  // namespace sherd
