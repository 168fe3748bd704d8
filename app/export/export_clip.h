// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/export/export_source.h"

namespace sherd {

/// The chosen frames on the topology of the last of them: where a crack is still to come, the vertices that
/// it will part are in the same place, that of the vertex they come from.
class Clip {
  public:
    explicit Clip(ExportSource& source);

    std::size_t frame_count() const { return source.frames().size(); }
    /// The last frame, a solid when that is asked for; the groups are the fragments.
    const TriangleSheet& topology() const { return last; }
    double time(std::size_t i);  ///< s, of the i-th frame
    /// Of the vertices of the last frame in the i-th: [V] m.
    std::vector<Vector3d> sheet_points(std::size_t i);
    /// Of the points of topology() in the i-th frame: [P] m.
    std::vector<Vector3d> points(std::size_t i);

  private:
    ExportSource& source;
    TriangleSheet last, last_sheet;
    std::vector<Index> origin;
};

}  // namespace sherd
