// SPDX-License-Identifier: GPL-3.0-or-later
// Tables of the fragments, and a mesh of each, for use in another physics engine.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "app/export/export_formats.h"
#include "app/export/export_sheet.h"
#include "app/export/fragment_motion.h"
#include "app/json/json.h"
#include "meshops/read_write/material_library.h"

namespace sherd {

namespace {

namespace fs = std::filesystem;

fs::path body_file(const ExportSource& source, std::size_t number, std::size_t fragment) {
    return source.frame_file(number, "_" + fragment_name(fragment) + ".obj");
}

constexpr const char* columns =
    "fragment,faces,mass,centre_x,centre_y,centre_z,velocity_x,velocity_y,velocity_z,spin_x,spin_y,spin_z,"
    "inertia_xx,inertia_yy,inertia_zz,inertia_xy,inertia_xz,inertia_yz,body\n";

std::string csv_content(ExportSource& source, std::size_t number) {
    std::string text = columns;
    const std::vector<FragmentMotion> all = fragment_motions(source.frame(number));
    for (std::size_t i = 0; i < all.size(); ++i) {
        const auto& [faces, mass, centre, inertia, velocity, spin] = all[i];
        const auto& in = inertia;
        const std::array<double, 16> numbers{
            mass,     centre.x(), centre.y(), centre.z(), velocity.x(), velocity.y(), velocity.z(), spin.x(),
            spin.y(), spin.z(),   in(0, 0),   in(1, 1),   in(2, 2),     in(0, 1),     in(0, 2),     in(1, 2)};
        text += fmt::format("{},{},{},{}\n", i, faces, fmt::join(numbers, ","),
                            body_file(source, number, i).filename().string());
    }
    return text;
}

std::string json_content(ExportSource& source, std::size_t number) {
    const Snapshot& frame = source.frame(number);
    Json table = {{"recording", source.options.recording.filename().string()},
                  {"frame", number},
                  {"time", frame.time},
                  {"units",
                   {{"time", "s"},
                    {"mass", "kg"},
                    {"centre", "m"},
                    {"velocity", "m/s"},
                    {"spin", "rad/s"},
                    {"inertia", "kg m^2, about the centre, along the axes of space"}}},
                  {"fragments", Json::array()},
                  {"obstacles", Json::array()}};
    const std::vector<FragmentMotion> all = fragment_motions(frame);
    for (std::size_t i = 0; i < all.size(); ++i) {
        const FragmentMotion& one = all[i];
        Json rows = Json::array();
        for (int row = 0; row < 3; ++row) rows.push_back(vector_json(Vector3d(one.inertia.row(row))));
        table["fragments"].push_back({{"fragment", i},
                                      {"faces", one.faces},
                                      {"mass", one.mass},
                                      {"centre", vector_json(one.centre)},
                                      {"velocity", vector_json(one.velocity)},
                                      {"spin", vector_json(one.spin)},
                                      {"inertia", rows},
                                      {"body", body_file(source, number, i).filename().string()}});
    }
    for (std::size_t i = 0; i < source.obstacles().size(); ++i)
        table["obstacles"].push_back(
            {{"obstacle", source.obstacles()[i].name},
             {"plane", source.obstacles()[i].plane},
             {"body", source.frame_file(number, source.obstacle_suffix(i, ".obj")).filename().string()}});
    return table.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace

std::vector<ExportJob> plan_fragments(ExportSource& source) {
    std::vector<ExportJob> jobs;
    for (const std::size_t number : source.frames()) {
        const std::size_t count = fragment_count(source.frame(number));
        for (std::size_t i = 0; i < count; ++i) {
            const fs::path file = body_file(source, number, i);
            const auto body = [&source, number, i] {
                TriangleSheet body = group_part(source.sheet(number), static_cast<std::int32_t>(i));
                body.group.clear();
                return body;
            };
            if (source.has_materials())
                jobs.push_back({material_file(file),
                                [body, file] { return material_text(body().look.material, file); }});
            jobs.push_back({file, [body, file] { return mesh_bytes(body(), file); }});
        }
        add_obstacle_files(source, number, ".obj", mesh_bytes, jobs);
        jobs.push_back(
            {source.frame_file(number, ".json"), [&source, number] { return json_content(source, number); }});
        jobs.push_back(
            {source.frame_file(number, ".csv"), [&source, number] { return csv_content(source, number); }});
    }
    return jobs;
}

}  // namespace sherd
