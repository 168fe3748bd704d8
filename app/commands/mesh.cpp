// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/scene/assemble/sheet/mesh.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <memory>
#include <set>

#include "app/commands/commands.h"
#include "app/files/disk/pending_file.h"
#include "app/files/plain_name.h"
#include "app/messages/nearest_name.h"
#include "app/messages/print.h"
#include "meshops/error.h"
#include "meshops/read_write/material_library.h"
#include "meshops/read_write/stl.h"
#include "meshops/read_write/text_line.h"
#include "meshops/read_write/write_mesh.h"

namespace sherd {
namespace {

namespace fs = std::filesystem;

struct MeshOptions {
    SceneOptions scene;
    std::string sheet;  ///< name of one sheet; empty: all
    fs::path output;
    bool placed = false, force = false;
};

/// A mesh and the file to write it to.
struct MeshJob {
    TriangleSheet sheet;
    fs::path file;
};

bool is_kind(const fs::path& file, std::string_view wanted) {
    return lower_case(file.extension().string()) == wanted;
}

std::vector<const SheetSpec*> chosen_sheets(const Scene& scene, const std::string& name) {
    std::vector<const SheetSpec*> chosen;
    std::vector<std::string> names;
    for (const SheetSpec& sheet : scene.sheets) {
        names.push_back(sheet.name);
        if (name.empty() || sheet.name == name) chosen.push_back(&sheet);
    }
    if (!chosen.empty()) return chosen;
    const std::string nearest = nearest_name(name, names);
    throw Error(fmt::format(
        "--sheet {}: {} has no sheet of this name; {}it has: {}", name, scene.file.string(),
        nearest.empty() ? "" : fmt::format("did you mean '{}'? ", nearest), fmt::join(names, ", ")));
}

TriangleSheet made(const SheetSpec& sheet, const Scene& scene, bool placed) {
    std::vector<std::string> warnings;
    std::string remeshed;
    TriangleSheet mesh = triangle_sheet(make_unplaced_mesh(sheet, scene, warnings, &remeshed));
    if (!remeshed.empty()) print_message("sherd: sheet.{}: {}\n", sheet.name, remeshed);
    print_warnings(warnings);
    if (!placed) return mesh;
    for (Vector3d& point : mesh.points) point = sheet.place * point;
    for (Vector3d& axis : mesh.look.axis) axis = sheet.place.linear() * axis;
    return mesh;
}

/// The files to write for a scene: an .obj file with an object for each sheet, or a file of another format
/// for each sheet.
std::vector<MeshJob> jobs_of(const Scene& scene, const MeshOptions& options) {
    const std::vector<const SheetSpec*> sheets = chosen_sheets(scene, options.sheet);
    const fs::path file = part_file(options.output, scene.variant);
    std::vector<MeshJob> jobs;
    TriangleSheet all;
    std::set<std::string> names;
    for (const SheetSpec* sheet : sheets) {
        TriangleSheet mesh = made(*sheet, scene, options.placed);
        if (sheets.size() == 1)
            jobs.push_back({std::move(mesh), file});
        else if (is_kind(file, ".obj"))
            add_group(all, mesh, sheet->name);
        else
            jobs.push_back({std::move(mesh), part_file(file, plain_name(sheet->name, names))});
    }
    if (jobs.empty()) jobs.push_back({std::move(all), file});
    return jobs;
}

int write_meshes(const MeshOptions& options) {
    const bool is_stl = is_kind(options.output, ".stl");
    if (!is_stl && !can_write_mesh(options.output))
        throw Error(fmt::format("'{}' ends in none of .obj, .ply, .off and .stl; name a file that does",
                                options.output.string()));
    std::vector<MeshJob> jobs;
    for (const Scene& scene : read_scenes(options.scene))
        for (MeshJob& job : jobs_of(scene, options)) {
            require_no_input(job.file, scene);
            check_free(job.file, options.force);
            if (has_material_file(job.sheet, job.file)) check_free(material_file(job.file), options.force);
            jobs.push_back(std::move(job));
        }
    for (const MeshJob& job : jobs) {
        const OutputLock lock(job.file);
        if (has_material_file(job.sheet, job.file)) {
            const fs::path materials = material_file(job.file);
            PendingFile pending(materials, Fault::input, lock);
            pending.write(material_text(job.sheet.look.material, job.file));
            pending.publish(options.force);
            print_result("{}\n", materials.string());
        }
        PendingFile pending(lock, Fault::input);
        pending.write(is_stl ? stl_bytes(job.sheet) : mesh_bytes(job.sheet, job.file));
        pending.publish(options.force);
        print_result("{}\n", job.file.string());
    }
    return 0;
}

}  // namespace

void add_mesh(CLI::App& program, Command& chosen) {
    CLI::App* command =
        program.add_subcommand("mesh", "Write the meshes of a scene's sheets, to look at or to paint on");
    auto options = std::make_shared<MeshOptions>();
    add_scene_options(*command, options->scene);
    command->add_option("--sheet", options->sheet, "Only this sheet (default: all)")->option_text("NAME");
    command
        ->add_option("-o,--output", options->output,
                     "File to write (.obj, .ply, .off, .stl). Several sheets become several objects in .obj, "
                     "and files NAME-SHEET.ext in the others; variants become files NAME-VARIANT.ext")
        ->required()
        ->option_text("FILE");
    command->add_flag("--placed", options->placed,
                      "Where the scene places them (default: as before `place`)");
    command->add_flag("--force", options->force, "Replace files that exist");
    command->footer("Example:\n  sherd mesh plate_drop -o plate.obj");
    command->callback([&chosen, options] { chosen = [options] { return write_meshes(*options); }; });
}

}  // namespace sherd
