// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "fracture/record/snapshot.h"

namespace sherd {

/// A fragment in a frame.
struct FragmentInfo {
    Index id = 0;
    Index parent = -1;  ///< fragment of which it was a part; -1: none, it is there from the start
    std::size_t faces = 0;
    double area = 0;  ///< m^2, at rest
    double mass = 0;  ///< kg
};

/// Returns the fragments of a frame by id, including those without a face. The mass of a vertex is
/// distributed to its faces by their rest areas. Parents are not set, since frames do not have them.
std::vector<FragmentInfo> fragments_of(const Snapshot& frame);

}  // namespace sherd
