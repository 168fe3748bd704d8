// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/export/export_source.h"

namespace sherd {

/// A kind of file that `sherd export` knows.
struct ExportFormat {
    const char* name;       ///< of --to
    const char* extension;  ///< of -o
    bool all_frames;        ///< what it is made for: the whole run, or a single moment
    bool fragments, solid;  ///< whether it knows these options
    bool bodies;            ///< whether it always writes what --solid does
    /// Says what is to be written, in this order. The jobs refer to the source.
    std::vector<ExportJob> (*plan)(ExportSource& source);
};

/// Returns the format that the options name. Throws Error (input) on an unknown name, and on options that the
/// format does not know.
const ExportFormat& export_format(const ExportOptions& options);
std::string export_format_names();  ///< "obj, ply, ..."

/// Makes the content of the file of a mesh, whose extension may say how.
using MeshContent = std::string (*)(const TriangleSheet& sheet, const std::filesystem::path& file);

/// Adds a file for each obstacle as it stands in a frame: NAME_000007_obstacle_ram.ply.
void add_obstacle_files(ExportSource& source, std::size_t frame, const std::string& extension,
                        MeshContent content, std::vector<ExportJob>& jobs);

std::vector<ExportJob> plan_obj(ExportSource& source);
std::vector<ExportJob> plan_ply(ExportSource& source);
std::vector<ExportJob> plan_stl(ExportSource& source);
std::vector<ExportJob> plan_pvd(ExportSource& source);
std::vector<ExportJob> plan_pc2(ExportSource& source);
std::vector<ExportJob> plan_mdd(ExportSource& source);
std::vector<ExportJob> plan_glb(ExportSource& source);
std::vector<ExportJob> plan_fragments(ExportSource& source);
std::vector<ExportJob> plan_vdb(ExportSource& source);

}  // namespace sherd
