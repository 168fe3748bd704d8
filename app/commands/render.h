// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/playback/slow_motion.h"

namespace sherd {

struct RenderOptions {
    std::filesystem::path recording;
    std::filesystem::path output;     ///< folder, or NAME.png for one picture; optional for a film
    std::string frames;               ///< as in ExportOptions; empty: all for a film, else the last
    std::string colour = "fragment";  ///< name in render_colours
    std::string range;                ///< LOW:HIGH of the coloured scalar; empty: range of the recording
    std::string size = "960x540";     ///< WxH, pixels
    int samples = 32;                 ///< number of samples per pixel
    std::string camera = "20,28";     ///< text for parse_camera()
    std::string ground = "auto";      ///< "auto" or "none"
    bool plain = false;               ///< whether colour bar and caption are left out
    std::filesystem::path film;       ///< file of a film, .mp4; empty: none
    SlowMotion slow;                  ///< speed of the film, whose pictures lie at and between frames
    int threads = 0;                  ///< number of threads; 0: as many as the processor runs at once
    bool force = false;               ///< whether existing files are replaced
};

struct Rendering {
    std::vector<std::filesystem::path> files;  ///< complete pictures, and the film last
    std::string legend;                        ///< meaning of the colours; may be empty
    bool interrupted = false;
};

/// Draws frames of a recording, or the pictures of a film. Throws Error (input), before anything is written,
/// on a bad recording or option and on files that exist, and (run) if a file cannot be written, with the
/// number of complete pictures.
Rendering render_recording(const RenderOptions& options);

}  // namespace sherd
