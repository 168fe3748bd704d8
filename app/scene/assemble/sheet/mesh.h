// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "app/scene/scene.h"
#include "meshops/mesh.h"

namespace sherd {

/// Reads the mesh of a file and scales it, but does not remesh it. Throws Error; warnings begin with the
/// file.
Mesh read_mesh(const MeshFile& spec, std::vector<std::string>& warnings);

/// Warns of sizes that are implausible in metres. size: m, the largest extent.
void warn_of_size(double size, std::vector<std::string>& warnings);

/// Makes the mesh of a sheet before it is placed: generated (with the scene's seed), or read, scaled and
/// remeshed. Throws Error naming the scene's line and key. Warnings are sentences that name the sheet's mesh.
/// If the mesh is remeshed, `remeshed` is set to a message on the distance from the file's surface.
Mesh make_unplaced_mesh(const SheetSpec& sheet, const Scene& scene, std::vector<std::string>& warnings,
                        std::string* remeshed = nullptr);

/// Makes the mesh of a sheet where the scene places it; otherwise like make_unplaced_mesh().
Mesh make_mesh(const SheetSpec& sheet, const Scene& scene, std::vector<std::string>& warnings,
               std::string* remeshed = nullptr);

}  // namespace sherd
