// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/export/export_source.h"
#include "app/playback/playback.h"

namespace sherd {

/// A run at several moments, with the vertices and faces of the last chosen frame at all of them. Before a
/// crack forms, the vertices that it will split coincide with their parent, and the parts of a face that it
/// will split lie flat in that face.
class Clip {
  public:
    /// moments: times of the chosen frames or between them; the last moment is the last chosen frame.
    Clip(ExportSource& source, std::vector<PlaybackTime> moments);

    std::size_t size() const { return moments.size(); }
    /// Returns the sheets in the last frame, as solids if the options ask for it; groups are fragments.
    const TriangleSheet& topology() const { return last; }
    double time(std::size_t i) const { return moments[i].time; }  ///< s, of the i-th moment
    /// Returns the positions of the vertices of the last frame at the i-th moment: [V] m.
    std::vector<Vector3d> sheet_points(std::size_t i);
    /// Returns the positions of the points of topology() at the i-th moment: [P] m.
    std::vector<Vector3d> points(std::size_t i);

  private:
    ExportSource& source;
    std::vector<PlaybackTime> moments;
    Playback playback;
    TriangleSheet last;
    Snapshot last_frame;
};

}  // namespace sherd
