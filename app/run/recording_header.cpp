// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/run/recording_header.h"

#include <algorithm>

#include "app/scene/assemble/sheet/supports.h"

namespace sherd {

RecordingHeader recording_header(const Scene& scene, const Simulation& simulation) {
    RecordingHeader header;
    header.scene_file = scene.file.string();
    header.scene_text = scene.text;
    header.seed = scene.seed;
    header.time_unit = scene.time_unit();
    for (const SheetSpec& sheet : scene.sheets) header.sheet_names.push_back(sheet.name);
    const RestMesh rest = simulation.snapshot().rest;
    header.rest_position = rest.position;
    header.rest_faces = rest.faces;
    header.rest_area = rest.area;
    header.rest_thickness = rest.thickness;
    header.rest_look = rest.look;
    header.rest_axis.assign(simulation.shell().axes().begin(), simulation.shell().axes().end());
    if (std::ranges::all_of(header.rest_axis, [](const Vector3d& axis) { return axis.isZero(0); }))
        header.rest_axis.clear();
    for (const auto& [name, kind] : support_names(scene)) header.supports.push_back({name, kind});
    const Shell& mechanics = simulation.shell().mechanics();
    for (std::size_t i = 0; i < scene.gauges.size(); ++i) {
        const Gauge& gauge = simulation.gauges()[i];
        header.gauges.push_back({scene.gauges[i].name, scene.sheets[mechanics.face_sheet[gauge.face]].name,
                                 gauge.place, gauge.displacement, gauge.fields});
        if (gauge.fields.any())
            header.gauges.back().axes =
                frame_axes(columns(mechanics.rest, mechanics.triangles[gauge.face].vertices));
    }
    return header;
}

}  // namespace sherd
