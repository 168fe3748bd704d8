// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/playback/slow_motion.h"

namespace sherd {

struct RenderOptions {
    std::filesystem::path recording;
    std::filesystem::path output;     ///< folder, or for one picture a file (NAME.png); a film needs none
    std::string frames;               ///< as of ExportOptions; empty: all of a film, else the last
    std::string colour = "fragment";  ///< a name of render_colours
    std::string range;                ///< LOW:HIGH of the scalar's colours; empty: that of the recording
    std::string size = "960x540";     ///< WxH, pixels
    int samples = 32;                 ///< of each pixel
    std::string camera = "20,28";     ///< as parse_camera reads it
    std::string ground = "auto";      ///< auto, none
    bool plain = false;               ///< without colour bar and caption
    std::filesystem::path film;       ///< .mp4; empty: none
    SlowMotion slow;                  ///< of the film, whose pictures are at and between the frames
    int threads = 0;                  ///< 0: as many as the processor runs at once
    bool force = false;               ///< replace files that exist
};

struct Rendering {
    std::vector<std::filesystem::path> files;  ///< complete pictures, and the film last
    std::string legend;                        ///< what the colours say; may be empty
    bool interrupted = false;
};

/// Draws frames of a recording or, of a film, the pictures that it has. Throws Error: (input) before anything
/// is written, on a bad recording or option and on files that exist, and (run) when a file cannot be written,
/// telling which are complete.
Rendering render_recording(const RenderOptions& options);

}  // namespace sherd
