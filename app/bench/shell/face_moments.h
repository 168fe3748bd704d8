// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "core/shell/face_fields.h"

namespace sherd {

/// Moments of a plate in the plane z = 0 at a point: m_xx, m_xy, m_yy, N, positive where they stretch the
/// side z > 0.
using PlateMoments = std::function<Eigen::Matrix2d(const Vector2d&)>;

/// 1 where a face's normal points to z, else -1.
double side_of(const Shell& shell, Index face);

/// Where the middle of a face is at rest.
Vector2d middle_of(const Shell& shell, Index face);

/// The moments of a face by the stress at its two surfaces, as PlateMoments has them. thickness: m.
Eigen::Matrix2d face_moments(const Shell& shell, const FaceFields& fields, Index face, double thickness);

/// How far moments of faces are from exact ones, over these, in the least squares of the faces whose middle
/// is at these distances from the origin. thickness: m.
double moments_error(const Shell& shell, const FaceFields& fields, const PlateMoments& exact,
                     double thickness, double from, double to);

}  // namespace sherd
