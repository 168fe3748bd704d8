// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/vector.h"

namespace sherd {

/// The signed principal strain of largest magnitude of a strain (E00, E11, 2 E01), as green_strain() gives
/// it.
double principal_strain(const Vector3d& strain);

}  // namespace sherd
