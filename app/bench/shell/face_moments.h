// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "core/shell/face_fields.h"

namespace sherd {

/// Moments of a plate in the plane z = 0 at a point (m): m_xx, m_xy and m_yy, N (moment per length), positive
/// where they stretch the side z > 0.
using PlateMoments = std::function<Eigen::Matrix2d(const Vector2d&)>;

/// Returns 1 if the normal of the face at rest points to z > 0, else -1.
double side_of(const Shell& shell, Index face);

/// The middle of a face at rest, m.
Vector2d middle_of(const Shell& shell, Index face);

/// Moments of a face in the form of PlateMoments, computed from the stress at its two surfaces. thickness: m.
Eigen::Matrix2d face_moments(const Shell& shell, const FaceFields& fields, Index face, double thickness);

/// Relative error of the faces' moments: the root mean square over the area of their difference from `exact`,
/// divided by that of `exact`. Only faces count whose middle is at least `from` and at most `to` (m) away
/// from the origin. thickness: m.
double moments_error(const Shell& shell, const FaceFields& fields, const PlateMoments& exact,
                     double thickness, double from, double to);

}  // namespace sherd
