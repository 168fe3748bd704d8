// SPDX-License-Identifier: GPL-3.0-or-later
// The formats of a single mesh: obj, ply, stl.
#include "app/export/export_formats.h"
#include "app/export/export_sheet.h"
#include "meshops/stl.h"

namespace sherd {

namespace {

using Content = std::string (*)(const TriangleSheet& sheet, const std::filesystem::path& file);

std::string stl_content(const TriangleSheet& sheet, const std::filesystem::path&) {
    return stl_bytes(sheet);
}

/// A file for each frame, or for each fragment of each frame.
std::vector<ExportJob> plan_files(ExportSource& source, const std::string& extension, bool by_fragment,
                                  Content content) {
    std::vector<ExportJob> jobs;
    const auto add = [&](std::size_t number, const std::filesystem::path& file,
                         std::optional<Index> fragment) {
        jobs.push_back({file, [&source, number, fragment, file, content] {
                            const TriangleSheet& sheet = source.sheet(number);
                            return content(fragment ? group_part(sheet, *fragment) : sheet, file);
                        }});
    };
    for (const std::size_t number : source.frames()) {
        if (!by_fragment) {
            add(number, source.frame_file(number, extension), {});
            continue;
        }
        const std::size_t count = fragment_count(source.frame(number));
        for (std::size_t i = 0; i < count; ++i)
            add(number, source.frame_file(number, "_" + fragment_name(i) + extension), static_cast<Index>(i));
    }
    return jobs;
}

std::string obj_of_one_object(const TriangleSheet& sheet, const std::filesystem::path& file) {
    TriangleSheet one = sheet;
    one.group.clear();
    return mesh_bytes(one, file);
}

}  // namespace

std::vector<ExportJob> plan_obj(ExportSource& source) {
    return plan_files(source, ".obj", false, source.options.fragments ? mesh_bytes : obj_of_one_object);
}

std::vector<ExportJob> plan_ply(ExportSource& source) {
    return plan_files(source, ".ply", source.options.fragments, mesh_bytes);
}

std::vector<ExportJob> plan_stl(ExportSource& source) {
    return plan_files(source, ".stl", source.options.fragments, stl_content);
}

}  // namespace sherd
