// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace sherd {

struct RenderOptions {
    std::filesystem::path recording;
    std::filesystem::path output;     ///< folder, or for one frame a file (NAME.png)
    std::string frames = "last";      ///< as of ExportOptions
    std::string colour = "fragment";  ///< fragment, strain, speed, axis, none
    std::string range;                ///< LOW:HIGH of the scalar's colours; empty: that of the recording
    std::string size = "960x540";     ///< WxH, pixels
    int samples = 32;                 ///< of each pixel
    std::string camera = "20,28";     ///< as parse_camera reads it
    std::string ground = "auto";      ///< auto, none
    bool plain = false;               ///< without colour bar and caption
    std::filesystem::path film;       ///< .mp4 of all pictures; empty: none
    double rate = 25;                 ///< the film's pictures a second
    int threads = 0;                  ///< 0: as many as the processor runs at once
    bool force = false;               ///< replace files that exist
};

struct Rendering {
    std::vector<std::filesystem::path> files;  ///< complete pictures, and the film last
    std::string legend;                        ///< what the colours say; may be empty
    bool interrupted = false;
};

/// Draws frames of a recording. Throws Error: (input) before anything is written, on a bad recording or
/// option and on files that exist, and (run) when a file cannot be written, telling which are complete.
Rendering render_recording(const RenderOptions& options);

}  // namespace sherd
