// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/playback/slow_motion.h"

namespace sherd {

struct ExportOptions {
    std::filesystem::path recording;
    std::string format = "obj";    ///< a name of export_format_names()
    std::filesystem::path output;  ///< file (NAME.obj) or folder; empty: beside the recording, named like it
    std::string frames;            ///< last, all, numbers, ranges START:STOP:STEP; empty: the format's own
    bool fragments = false;        ///< one object (obj) or one file (ply, stl) for each fragment
    bool sheets_only = false;      ///< without obstacles and free bodies
    bool solid = false;            ///< bodies of the sheets' thickness (obj, ply, stl, glb)
    std::optional<double> thickness;  ///< m, instead of the recording's
    std::string quality = "strain";   ///< main scalar of ply: a name of face_quality()
    std::string animate = "rigid";    ///< how glb moves: rigid, morph
    std::optional<double> voxel;      ///< m, of vdb; a quarter of the smallest thickness
    SlowMotion slow;                  ///< of glb, pc2 and mdd; the rate of pc2 and mdd
    bool force = false;               ///< replace files that exist
};

/// Returns the frames that `text` selects out of `count`, ascending, each once. Throws Error (input) on a
/// text that is none of those above, on a frame that does not exist, and on a selection of nothing.
std::vector<std::size_t> selected_frames(const std::string& text, std::size_t count);

/// Holds what an export has written, and what a user should know of it.
struct ExportReport {
    std::vector<std::filesystem::path> files;
    std::vector<std::string> warnings;
    std::string pace;  ///< how fast the run is shown; may be empty
};

/// Writes meshes of the frames of a recording. One frame and an output NAME.obj make that file; several make
/// NAME_000000.obj and so on, numbered by frame, and so does a folder. Every file appears under its name when
/// it is complete. Before anything is written it throws Error (input) on a bad recording, selection or output
/// and on files that exist. It throws Error (run) when a file cannot be written or on interrupted(), telling
/// which files are complete.
ExportReport export_recording(const ExportOptions& options);

}  // namespace sherd
