// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/shell/shell.h"

namespace sherd {

/// Mean length of edges at rest, m, an edge counted once for each of its triangles; infinite if there are no
/// triangles.
double mean_edge_length(const Shell& shell);

}  // namespace sherd
