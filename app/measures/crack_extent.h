// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/measures/crack_graph.h"

namespace sherd {

/// What has broken by a frame, at rest.
struct CrackExtent {
    double length = 0;  ///< m, of edges that failed, each once however many sides it has now
    double area = 0;    ///< m^2, with the thickness of what they parted; 0 where that is not recorded
};

CrackExtent crack_extent(const CrackGraph& cracks, const RestMesh& rest);

}  // namespace sherd
