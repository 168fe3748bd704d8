// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/export/export_clip.h"

#include <utility>

#include "app/export/export_sheet.h"
#include "app/playback/frame_parents.h"
#include "meshops/solid/thicken.h"

namespace sherd {

Clip::Clip(ExportSource& source, std::vector<PlaybackTime> moments_)
    : source(source),
      moments(std::move(moments_)),
      playback([&source](std::size_t number) { return source.frame(number); }),
      last(source.sheet(source.frames().back())),
      last_frame(source.frame(source.frames().back())) {}

std::vector<Vector3d> Clip::sheet_points(std::size_t i) {
    const Snapshot frame = playback.at(moments[i]);
    const Positions places = frame_parents(frame, last_frame).interpolated_from(frame.position);
    return {places.colwise().begin(), places.colwise().end()};
}

std::vector<Vector3d> Clip::points(std::size_t i) {
    if (!source.options.solid) return sheet_points(i);
    TriangleSheet sheet = frame_sheet(last_frame);
    sheet.points = sheet_points(i);
    return thickened(sheet, source.thickness(last_frame), last_frame.original).points;
}

}  // namespace sherd
