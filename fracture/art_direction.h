// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace sherd {

/// What keeps a sheet whole whatever it bears, because a picture wants it so.
struct ArtDirection {
    double after = 0;     ///< s; nothing of it fails before this time
    double smallest = 0;  ///< m; the root of the area of the smallest piece that may come off it; 0: any
};

}  // namespace sherd
