// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <span>
#include <string>

#include "fracture/record/snapshot.h"
#include "meshops/read_write/write_mesh.h"

namespace sherd {

/// Returns the content of a VTK file of a frame (.vtp: XML that any parser reads, with numbers in base64 of
/// blocks that zlib has compressed). It has the faces with `fragment`, `sheet`, `strain` (1/m, largest of the
/// face's edges), their fields and the principal values of the fields, and the vertices with `speed` and
/// `velocity`. Faces and vertices keep their order; copies of vertices follow, as in split_points().
std::string vtp_bytes(const Snapshot& frame);

/// Returns the content of a .vtp file of triangles without further data.
std::string vtp_bytes(const TriangleSheet& mesh);

/// File of a part of a frame, and its time.
struct TimedFile {
    std::filesystem::path file;
    double time = 0;       ///< s
    std::size_t part = 0;  ///< number of the part among the parts of the same time
    std::string name;      ///< name of the part
};

/// Returns the content of a .pvd file that refers to files in the same folder. files: by time, ascending.
std::string pvd_text(std::span<const TimedFile> files);

}  // namespace sherd
