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
    std::string frames;        ///< last, all, numbers, ranges START:STOP:STEP; empty: the format's default
    bool fragments = false;    ///< whether each fragment is an object (obj) or a file (ply, stl)
    bool sheets_only = false;  ///< whether obstacles and free bodies are left out
    bool solid = false;        ///< whether sheets become bodies of their thickness: see ExportFormat::solid
    std::optional<double> thickness;  ///< m, of all sheets; none: as recorded
    std::string quality = "strain";   ///< main scalar of ply: a name of face_quality()
    std::string animate = "rigid";    ///< motion in glb: rigid, morph
    std::optional<double> voxel;      ///< m, size of voxels in vdb; none: a quarter of the smallest thickness
    SlowMotion slow;                  ///< the factor is for glb, pc2 and mdd, the rate for pc2 and mdd
    bool force = false;               ///< whether existing files are replaced
};

/// Returns the numbers of the frames that `text` selects out of `count` frames, ascending, each once. Throws
/// Error (input) on a text that ExportOptions::frames does not allow, on a frame that does not exist, and if
/// no frame is selected.
std::vector<std::size_t> selected_frames(const std::string& text, std::size_t count);

/// Files of an export, and its messages for the user.
struct ExportReport {
    std::vector<std::filesystem::path> files;
    std::vector<std::string> warnings;
    std::string pace;  ///< speed at which the run is shown; may be empty
};

/// Writes meshes of the frames of a recording. If the output is a file NAME.obj, a single frame goes to this
/// file, and several frames go to NAME_000000.obj and so on, numbered by frame. If the output is a folder,
/// the files in it are numbered in any case. Every file appears under its name when it is complete. Throws
/// Error (input), before anything is written, on a bad recording, selection or output, and on files that
/// exist, unless options.force. Throws Error (run) with the number of complete files if a file cannot be
/// written, or on interrupted().
ExportReport export_recording(const ExportOptions& options);

}  // namespace sherd
