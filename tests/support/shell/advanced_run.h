// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "app/recording/recording.h"
#include "fracture/record/fragments.h"
#include "tests/support/shell/advanced_sheet.h"

namespace sherd::test {

/// Header of a run of advanced_frames().
inline RecordingHeader advanced_header(const Snapshot& first) {
    RecordingHeader header;
    header.scene_file = "advanced.toml";
    header.scene_text = "duration = 1\n";
    header.sheet_names = {"sheet"};
    header.rest_position = first.rest.position;
    header.rest_faces = first.rest.faces;
    header.rest_area = first.rest.area;
    header.rest_thickness = first.rest.thickness;
    header.rest_look = first.rest.look;
    return header;
}

/// Frames of a sheet in which Advances makes edges and lets some fail. linear: map from the rest shape to the
/// positions.
inline std::vector<Snapshot> advanced_frames(unsigned shape, unsigned seed, const Matrix3d& linear) {
    BreakableShell sheet({directed_input(shape, seed)});
    Fragments fragments(sheet.mesh(), sheet.face_areas());
    Advances advances(sheet, seed + 1);
    std::vector<Snapshot> frames;
    for (int k = 0; k < 6; ++k) {
        sheet.mechanics().position = linear * sheet.mechanics().rest;
        frames.push_back(take_snapshot(sheet, fragments.of_face()));
        frames.back().step = k;
        frames.back().time = 0.1 * k;
        for (int i = 0; i < 4; ++i) {
            const auto advanced = advances.next();
            if (!advanced) continue;
            fragments.follow(advanced->change.cracks.topology);
            if (advances.random_bool()) advances.fail(advanced->halfedge);
        }
        fragments.update(sheet.mesh(), sheet.face_areas());
    }
    return frames;
}

}  // namespace sherd::test
