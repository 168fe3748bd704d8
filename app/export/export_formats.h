// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/export/export_source.h"

namespace sherd {

/// A file format of `sherd export`.
struct ExportFormat {
    const char* name;       ///< name in --to
    const char* extension;  ///< extension in -o
    bool all_frames;        ///< whether all frames are selected by default, instead of the last one
    bool fragments, solid;  ///< whether it supports these options
    bool bodies;            ///< whether it always writes solids
    /// Returns the files to be written, in this order. The source must outlive the jobs.
    std::vector<ExportJob> (*plan)(ExportSource& source);
};

/// Returns the format that the options name. Throws Error (input) on an unknown name, and on options that the
/// format does not support.
const ExportFormat& export_format(const ExportOptions& options);
std::string export_format_names();  ///< "obj, ply, ..."

/// Returns the content of a mesh file, in the format of its extension.
using MeshContent = std::string (*)(const TriangleSheet& sheet, const std::filesystem::path& file);

/// Adds a job to `jobs` for a file of each obstacle in a frame: NAME_000007_obstacle_ram.ply.
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
