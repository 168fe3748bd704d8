// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace sherd {

/// Limits on the fracture of a sheet, whatever its load, for the sake of a picture.
struct ArtDirection {
    double after = 0;     ///< s; no edge of the sheet fails before this time
    double smallest = 0;  ///< m; square root of the area of the smallest piece that may separate; 0: any
};

}  // namespace sherd
