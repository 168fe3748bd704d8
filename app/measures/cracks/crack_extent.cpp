// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/measures/cracks/crack_extent.h"

namespace sherd {

CrackExtent crack_extent(const CrackGraph& cracks, const RestMesh& rest) {
    CrackExtent extent;
    for (const auto& [vertices, faces, length] : cracks.edges) {
        extent.length += length;
        if (!rest.thickness.empty())
            extent.area += length * (rest.thickness[faces[0]] + rest.thickness[faces[1]]) / 2;
    }
    return extent;
}

}  // namespace sherd
