// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <vector>

namespace sherd {

/// Holds what the index says of a frame of a recording.
struct XdmfFrame {
    double time = 0;  ///< s
    std::size_t vertices = 0, faces = 0, edges = 0;
    std::vector<std::string> fields = {};  ///< names of its fields of faces
};

/// Returns the text of an .xdmf file (XDMF 2, for ParaView's XDMFReader). It shows the frames of the
/// recording `recording_name`, a file name without folder, as two collections in time, whose topology may
/// change from frame to frame: `surface` (triangles: fragment, sheet, fields and their principal values;
/// vertices: speed, velocity) and `edges` (lines: state, strain).
std::string xdmf_text(const std::string& recording_name, std::span<const XdmfFrame> frames);

}  // namespace sherd
