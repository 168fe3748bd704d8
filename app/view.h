// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace sherd {

struct ViewOptions {
    std::filesystem::path recording;
    std::filesystem::path output;  ///< .html; empty: beside the recording, named like it
    std::optional<double> slow;    ///< how many times slower than reality; none: default_slowdown()
    std::string colour;            ///< of view_colours; empty: strain
    double megabytes = 64;         ///< of data in the page; beyond, frames are left out, then meshes thinned
    bool plain = false;            ///< without colour bar and caption
    bool force = false;            ///< replace a file that exists
};

/// One page of HTML that plays a recording in a browser, from a file and without a network. Warns of frames
/// and looks that are left out. Throws Error (input) on a bad recording.
std::string view_page(const ViewOptions& options, std::vector<std::string>& warnings);

}  // namespace sherd
