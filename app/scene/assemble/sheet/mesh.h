// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "app/scene/scene.h"
#include "meshops/mesh.h"

namespace sherd {

/// Reads the mesh of a file and scales it, but does not remesh it. Throws Error naming the file; warnings are
/// sentences.
Mesh read_mesh(const MeshFile& spec, std::vector<std::string>& warnings);

/// Adds a warning if the size of a mesh is implausible in metres. size: m, largest side of the bounding box.
void warn_of_size(double size, std::vector<std::string>& warnings);

/// Makes the mesh of a sheet before it is placed: generates it (with the scene's seed), reads and scales it,
/// or takes it from a program, and remeshes it if the sheet asks for that. Throws Error naming the scene's
/// line and key. Warnings are sentences that name the sheet's mesh. If the mesh is remeshed and `remeshed` is
/// not null, `remeshed` is set to a message on the distance from the file's surface.
Mesh make_unplaced_mesh(const SheetSpec& sheet, const Scene& scene, std::vector<std::string>& warnings,
                        std::string* remeshed = nullptr);

/// Makes the mesh of a sheet like make_unplaced_mesh(), and places it. Throws Error also if the placed mesh
/// is so far from the origin that doubles do not resolve its edges.
Mesh make_mesh(const SheetSpec& sheet, const Scene& scene, std::vector<std::string>& warnings,
               std::string* remeshed = nullptr);

}  // namespace sherd
