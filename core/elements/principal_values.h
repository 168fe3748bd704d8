// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/vector.h"

namespace sherd {

/// The principal values of a symmetric tensor in the plane, (00, 11, 01), the larger one first.
Vector2d principal_values(const Vector3d& tensor);

/// Converts a strain or curvature (00, 11, 2 * 01) to the components (00, 11, 01) of its tensor.
inline Vector3d tensor_of_strain(const Vector3d& strain) {
    return {strain[0], strain[1], strain[2] / 2};
}

/// The signed principal value of largest magnitude of a strain (E00, E11, 2 E01), as green_strain() gives it,
/// or of a curvature.
double principal_strain(const Vector3d& strain);

}  // namespace sherd
