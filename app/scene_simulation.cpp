// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/scene_simulation.h"

#include "app/scene_mesh.h"

namespace sherd {

std::vector<SheetInput> make_sheets(const Scene& scene, std::vector<std::string>& warnings) {
    std::vector<SheetInput> inputs;
    for (const SheetSpec& sheet : scene.sheets) {
        SheetInput input;
        input.mesh = make_mesh(sheet, scene, warnings);
        input.pinned = pinned_vertices(sheet, input.mesh);
        const MaterialSpec& material = sheet.material;
        input.material = {material.density, material.thickness, material.young, material.poisson};
        input.strain_threshold = sheet.strain_threshold;
        input.velocity = sheet.velocity;
        input.spin = sheet.spin;
        inputs.push_back(std::move(input));
    }
    return inputs;
}

SimulationOptions simulation_options(const Scene& scene) {
    SimulationOptions options;
    options.step = scene.solver.step;
    options.gravity = scene.gravity;
    options.max_iterations = scene.solver.max_iterations;
    options.tolerance = scene.solver.tolerance;
    options.max_stages = scene.solver.max_stages;
    for (const PlaneSpec& plane : scene.planes)
        options.planes.push_back({plane.point, plane.normal.normalized(), plane.young, plane.friction});
    return options;
}

RecordingHeader recording_header(const Scene& scene, const Simulation& simulation) {
    RecordingHeader header;
    header.scene_file = scene.file.string();
    header.scene_text = scene.text;
    header.seed = scene.seed;
    for (const SheetSpec& sheet : scene.sheets) header.sheet_names.push_back(sheet.name);
    const Sheet& mechanics = simulation.sheet().mechanics();
    header.rest_position = mechanics.rest;
    for (const TriangleStencil& triangle : mechanics.triangles) {
        header.rest_faces.push_back(triangle.vertices);
        header.rest_area.push_back(triangle.membrane.area);
    }
    return header;
}

}  // namespace sherd
