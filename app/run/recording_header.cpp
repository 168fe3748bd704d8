// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/run/recording_header.h"

namespace sherd {

RecordingHeader recording_header(const Scene& scene, const Simulation& simulation) {
    RecordingHeader header;
    header.scene_file = scene.file.string();
    header.scene_text = scene.text;
    header.seed = scene.seed;
    for (const SheetSpec& sheet : scene.sheets) header.sheet_names.push_back(sheet.name);
    const Shell& mechanics = simulation.shell().mechanics();
    header.rest_position = mechanics.rest;
    for (const TriangleStencil& triangle : mechanics.triangles) {
        header.rest_faces.push_back(triangle.vertices);
        header.rest_area.push_back(triangle.membrane.area);
    }
    for (const Index sheet : simulation.shell().face_sheet())
        header.rest_thickness.push_back(scene.sheets[sheet].material.thickness);
    return header;
}

}  // namespace sherd
