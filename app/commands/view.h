// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace sherd {

struct ViewOptions {
    std::filesystem::path recording;
    std::filesystem::path output;  ///< .html; empty: the recording's name, with this extension
    std::optional<double> slow;    ///< factor of slow motion; none: default_slowdown()
    std::string colour;            ///< name in view_colours; empty: strain
    double megabytes = 64;         ///< MB of data, for which frames are left out and the mesh is thinned
    bool plain = false;            ///< whether colour bar and caption are left out
    bool force = false;            ///< whether an existing file is replaced
};

/// An HTML page that plays a recording in a browser, from a file and without a network. Warns if frames,
/// materials or colours are left out, or the mesh is thinned. Throws Error (input) on a bad recording.
std::string view_page(const ViewOptions& options, std::vector<std::string>& warnings);

}  // namespace sherd
