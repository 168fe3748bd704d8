// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace sherd {

struct ExportOptions {
    std::filesystem::path recording;
    std::string format = "obj";    ///< obj, ply
    std::filesystem::path output;  ///< file (NAME.obj) or folder; empty: beside the recording, named like it
    std::string frames = "last";   ///< last, all, or numbers and ranges START:STOP:STEP as in Python
    bool fragments = false;        ///< one object (OBJ) or one file (PLY) for each fragment
    bool force = false;            ///< replace files that exist
};

/// The frames that `text` selects out of `count`, ascending, each once. Throws Error (input) on a text that
/// is none of those above, a frame that does not exist, and a selection of nothing.
std::vector<std::size_t> selected_frames(const std::string& text, std::size_t count);

/// Writes meshes of the frames of a recording and returns their files. One frame and an output NAME.obj make
/// that file, several make NAME_000000.obj and so on, numbered by frame, and so does a folder. Throws Error:
/// (input) before anything is written, on a bad recording, selection or output and on files that exist, and
/// (run) when a file cannot be written, telling which are complete.
std::vector<std::filesystem::path> export_recording(const ExportOptions& options);

}  // namespace sherd
