// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "fracture/record/snapshot.h"

namespace sherd {

/// A fragment in a frame.
struct FragmentInfo {
    Index id = 0;
    Index parent = -1;  ///< fragment of which it was a part; -1: none, or unknown
    std::size_t faces = 0;
    double area = 0;  ///< m^2, at rest
    double mass = 0;  ///< kg
};

/// Returns the fragments of a frame by id, including fragments without a face. The mass of each vertex is
/// distributed to the faces around it in proportion to their rest areas. Parents are not set, since frames do
/// not record them.
std::vector<FragmentInfo> fragments_of(const Snapshot& frame);

}  // namespace sherd
