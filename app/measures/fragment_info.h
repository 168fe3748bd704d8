// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "fracture/snapshot.h"

namespace sherd {

/// A connected piece in a frame.
struct FragmentInfo {
    Index id = 0;
    Index parent = -1;  ///< the piece that it was a part of; -1: it was there from the beginning
    std::size_t faces = 0;
    double area = 0;  ///< m^2, at rest
    double mass = 0;  ///< kg
};

/// Those of a frame by id, those without a face included. The mass of a vertex goes to its faces as their
/// rest areas. Of parents frames know nothing.
std::vector<FragmentInfo> fragments_of(const Snapshot& frame);

}  // namespace sherd
