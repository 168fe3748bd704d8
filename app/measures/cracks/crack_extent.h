// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/measures/cracks/crack_graph.h"

namespace sherd {

/// Extent of the cracks of a frame, at rest.
struct CrackExtent {
    double length = 0;  ///< m, of failed edges, each once however many sides it has now
    double area = 0;    ///< m^2, with the thickness of the adjacent faces; 0 if that is not recorded
};

CrackExtent crack_extent(const CrackGraph& cracks, const RestMesh& rest);

}  // namespace sherd
