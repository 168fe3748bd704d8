// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "fracture/snapshot.h"

namespace sherd {

/// What has broken by a frame, at rest.
struct CrackExtent {
    double length = 0;  ///< m, of edges that failed, each once however many sides it has now
    double area = 0;    ///< m^2, with the thickness of what they parted; 0 where that is not recorded
};

/// Edges count that two faces share at rest, and that are open in the frame or have failed without opening.
CrackExtent crack_extent(const Snapshot& frame);

}  // namespace sherd
