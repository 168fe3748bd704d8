// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/elements/principal_strain.h"

#include <cmath>

namespace sherd {

double principal_strain(const Vector3d& strain) {
    const double mean = (strain[0] + strain[1]) / 2;
    const double radius = std::hypot((strain[0] - strain[1]) / 2, strain[2] / 2);
    return mean < 0 ? mean - radius : mean + radius;
}

}  // namespace sherd
