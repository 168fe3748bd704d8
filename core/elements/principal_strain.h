// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/vector.h"

namespace sherd {

/// Principal strain of largest magnitude, signed, of a strain (E00, E11, 2 E01) such as green_strain() gives.
double principal_strain(const Vector3d& strain);

}  // namespace sherd
