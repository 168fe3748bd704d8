// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>
#include <vector>

#include "core/vector.h"
#include "fracture/edge_state.h"

namespace sherd {

/// The shell at one moment, as plain arrays: what a recording stores of a frame. From one snapshot of a run
/// to the next vertices and edges are only appended; faces stay the same.
struct Snapshot {
    std::int64_t step = 0;
    double time = 0;  ///< s

    Positions position;           ///< [3, V] m
    Positions velocity;           ///< [3, V] m/s
    VectorXd mass;                ///< [V] kg
    std::vector<Index> original;  ///< [V] vertex of the unbroken mesh that this one is, or is a copy of

    std::vector<std::array<Index, 3>> faces;  ///< [F]
    std::vector<Index> face_fragment;         ///< [F] number of each face's fragment
    std::vector<Index> face_sheet;            ///< [F] number of the sheet in the scene

    std::vector<std::array<Index, 2>> edges;  ///< [E] end points
    std::vector<EdgeState> edge_state;        ///< [E]
    std::vector<double> edge_strain;          ///< [E] 1/m, signed bending strain; zero without a hinge
};

class BreakableSheet;

/// Takes a snapshot of the current state; the caller sets step and time. face_fragment: [F].
Snapshot take_snapshot(const BreakableSheet& sheet, std::span<const Index> face_fragment);

}  // namespace sherd
