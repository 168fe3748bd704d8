// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/measures/cracks/crack_graph.h"

namespace sherd {

/// Extent of the cracks of a frame, at rest.
struct CrackExtent {
    double length = 0;  ///< m, length of failed edges; an edge that has opened into two counts once
    double area = 0;    ///< m^2, length times mean thickness of both faces; 0 if none is recorded
};

CrackExtent crack_extent(const CrackGraph& cracks, const RestMesh& rest);

}  // namespace sherd
