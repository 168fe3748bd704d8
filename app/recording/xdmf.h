// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <iosfwd>
#include <span>
#include <string>
#include <vector>

#include "core/state_visitor.h"

namespace sherd {

/// Entry of the index for a frame of a recording.
struct XdmfFrame {
    double time = 0;  ///< s
    std::size_t vertices = 0, faces = 0, edges = 0;
    std::vector<std::string> obstacles = {};  ///< path of the dataset with each obstacle's points
    std::vector<std::string> fields = {};     ///< names of the face fields that it has

    void visit_state(StateVisitor& visit) {
        auto& [time, vertices, faces, edges, obstacles, fields] = *this;
        visit(time, vertices, faces, edges, obstacles, fields);
    }
};

/// Entry of the index for an obstacle.
struct XdmfObstacle {
    std::string name;
    std::size_t points = 0, triangles = 0;
};

/// Writes the text of an .xdmf file (XDMF 2, for ParaView's XDMFReader), which shows the frames of the
/// recording `recording_name`, a file name without folder. There are two collections in time, whose topology
/// may change from frame to frame: `surface` (triangles: fragment, sheet, fields and their principal values;
/// vertices: speed, velocity) and `edges` (lines: state, strain). Each obstacle is a further collection,
/// `obstacle NAME`, or a grid without time if it does not move.
void write_xdmf(std::ostream& out, const std::string& recording_name, std::span<const XdmfFrame> frames,
                std::span<const XdmfObstacle> obstacles);

}  // namespace sherd
