// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/export/export_clip.h"

#include <utility>

#include "app/export/export_sheet.h"
#include "meshops/thicken.h"

namespace sherd {

Clip::Clip(ExportSource& source, std::vector<Moment> moments_)
    : source(source),
      moments(std::move(moments_)),
      playback([&source](std::size_t number) { return source.frame(number); }),
      last(source.sheet(source.frames().back())),
      last_sheet(frame_sheet(source.frame(source.frames().back()))),
      origin(source.frame(source.frames().back()).original) {}

std::vector<Vector3d> Clip::sheet_points(std::size_t i) {
    // A face keeps its corners; a corner's vertex in an earlier frame is what the later one was split from.
    const Snapshot frame = playback.at(moments[i]);
    std::vector<Vector3d> points(last_sheet.points.size());
    for (std::size_t f = 0; f < frame.faces.size(); ++f)
        for (int k = 0; k < 3; ++k)
            points[last_sheet.triangles[f][k]] = frame.position.col(frame.faces[f][k]);
    return points;
}

std::vector<Vector3d> Clip::points(std::size_t i) {
    if (!source.options.solid) return sheet_points(i);
    TriangleSheet sheet = last_sheet;
    sheet.points = sheet_points(i);
    return thickened(sheet, source.thickness(), origin).points;
}

}  // namespace sherd
