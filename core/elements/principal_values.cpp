// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/elements/principal_values.h"

#include <cmath>

namespace sherd {

Vector2d principal_values(const Vector3d& tensor) {
    const double mean = (tensor[0] + tensor[1]) / 2;
    const double radius = std::hypot((tensor[0] - tensor[1]) / 2, tensor[2]);
    return {mean + radius, mean - radius};
}

double principal_strain(const Vector3d& strain) {
    const Vector2d principal = principal_values(tensor_of_strain(strain));
    return strain[0] + strain[1] < 0 ? principal[1] : principal[0];
}

}  // namespace sherd
