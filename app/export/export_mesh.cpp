// SPDX-License-Identifier: GPL-3.0-or-later
// The formats with a single mesh in each file: obj, ply, stl.
#include "app/export/corner_normals.h"
#include "app/export/export_formats.h"
#include "app/export/export_sheet.h"
#include "meshops/read_write/material_library.h"
#include "meshops/read_write/stl.h"

namespace sherd {

namespace {

std::string stl_content(const TriangleSheet& sheet, const std::filesystem::path&) {
    return stl_bytes(sheet);
}

/// Plans, for each frame, a file of the sheets or of each fragment, and a file of each obstacle.
std::vector<ExportJob> plan_files(ExportSource& source, const std::string& extension, MeshContent content) {
    std::vector<ExportJob> jobs;
    const auto add = [&](std::size_t number, const std::filesystem::path& file,
                         std::optional<Index> fragment) {
        jobs.push_back({file, [&source, number, fragment, file, content] {
                            const TriangleSheet& sheet = source.sheet(number);
                            return content(fragment ? group_part(sheet, *fragment) : sheet, file);
                        }});
    };
    for (const std::size_t number : source.frames()) {
        if (!source.options.fragments) add(number, source.frame_file(number, extension), {});
        const std::size_t count = source.options.fragments ? fragment_count(source.frame(number)) : 0;
        for (std::size_t i = 0; i < count; ++i)
            add(number, source.frame_file(number, "_" + fragment_name(i) + extension), static_cast<Index>(i));
        add_obstacle_files(source, number, extension, content, jobs);
    }
    return jobs;
}

/// Returns the sheets as a single object, or as an object for each fragment, and each obstacle as an object.
TriangleSheet obj_sheet(ExportSource& source, std::size_t number) {
    TriangleSheet all = source.sheet(number);
    all.quality.clear();
    if (!source.options.fragments) {
        all.group.clear();
        if (source.obstacles().empty()) return all;
        all.group.assign(all.triangles.size(), 0);
        all.group_names = {"sheets"};
    }
    for (std::size_t i = 0; i < source.obstacles().size(); ++i) {
        TriangleSheet obstacle = source.obstacle(i, number);
        if (!all.normal.empty()) obstacle.normal = creased_normals(obstacle);
        add_group(all, obstacle, source.obstacles()[i].name);
    }
    return all;
}

}  // namespace

std::vector<ExportJob> plan_obj(ExportSource& source) {
    std::vector<ExportJob> jobs;
    for (const std::size_t number : source.frames()) {
        const std::filesystem::path file = source.frame_file(number, ".obj");
        // The file of materials comes first: a program that waits for the .obj finds both.
        if (source.has_materials())
            jobs.push_back({material_file(file), [&source, number, file] {
                                return material_text(obj_sheet(source, number).look.material, file);
                            }});
        jobs.push_back(
            {file, [&source, number, file] { return mesh_bytes(obj_sheet(source, number), file); }});
    }
    return jobs;
}

std::vector<ExportJob> plan_ply(ExportSource& source) {
    return plan_files(source, ".ply", mesh_bytes);
}

std::vector<ExportJob> plan_stl(ExportSource& source) {
    return plan_files(source, ".stl", stl_content);
}

}  // namespace sherd
