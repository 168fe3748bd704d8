// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <span>
#include <string>

#include "fracture/record/snapshot.h"
#include "meshops/read_write/write_mesh.h"

namespace sherd {

/// Returns the content of a VTK file (.vtp, XML that any parser reads, numbers in base64 of zlib's blocks) of
/// a frame: its faces with `fragment`, `sheet` and `strain` (1/m, largest of the face's edges), their fields
/// and the principal values of these, and its vertices with `speed` and `velocity`, all in the frame's order.
std::string vtp_bytes(const Snapshot& frame);

/// Returns the content of a .vtp file of triangles alone.
std::string vtp_bytes(const TriangleSheet& mesh);

/// File of a part of a frame, and its time.
struct TimedFile {
    std::filesystem::path file;
    double time = 0;       ///< s
    std::size_t part = 0;  ///< number of the part among those of one time
    std::string name;      ///< name of the part
};

/// Returns the content of a .pvd file that refers to files in the same folder: those of one time together,
/// times in their order.
std::string pvd_text(std::span<const TimedFile> files);

}  // namespace sherd
