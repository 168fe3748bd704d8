// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/export/export_formats.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "meshops/error.h"

namespace sherd {

namespace {

constexpr std::array<ExportFormat, 9> formats{{
    {"obj", ".obj", false, true, true, false, plan_obj},
    {"ply", ".ply", false, true, true, false, plan_ply},
    {"stl", ".stl", false, true, true, false, plan_stl},
    {"pvd", ".pvd", true, false, false, false, plan_pvd},
    {"pc2", ".pc2", true, false, true, false, plan_pc2},
    {"mdd", ".mdd", true, false, true, false, plan_mdd},
    {"glb", ".glb", true, true, true, false, plan_glb},
    {"vdb", ".vdb", false, false, true, false, plan_vdb},
    {"fragments", ".csv", false, false, false, true, plan_fragments},
}};

std::string names_where(bool ExportFormat::*property) {
    std::string names;
    for (const ExportFormat& format : formats)
        if (property == nullptr || format.*property)
            names += (names.empty() ? "" : ", ") + std::string(format.name);
    return names;
}

void check_option(const ExportFormat& format, bool given, const char* option, bool ExportFormat::*known) {
    if (given && !(format.*known))
        throw Error(
            fmt::format("--to {} does not support {}; {} do", format.name, option, names_where(known)));
}

void check_choice(const char* option, const std::string& given, const std::vector<std::string>& known) {
    if (std::ranges::find(known, given) == known.end())
        throw Error(
            fmt::format("{} {}: there is no such choice; give {}", option, given, fmt::join(known, " or ")));
}

void check_length(const char* option, const std::optional<double>& given) {
    if (given && !(*given > 0 && std::isfinite(*given)))
        throw Error(fmt::format("{} {}: give a length in m, above 0", option, *given));
}

void check_values(const ExportOptions& options) {
    check_choice("--quality", options.quality, {"strain", "speed", "fragment", "stress", "curvature"});
    check_choice("--animate", options.animate, {"rigid", "morph"});
    check_length("--voxel", options.voxel);
    check_length("--thickness", options.thickness);
    check_slow_motion(options.slow);
}

/// Throws Error (input) on an option that has no effect on the format. standard: the default options.
void check_use(const ExportOptions& options, const ExportOptions& standard) {
    const auto require = [](bool holds, const char* option, const char* use) {
        if (!holds) throw Error(fmt::format("{} is used {} only", option, use));
    };
    const std::string& format = options.format;
    require(options.quality == standard.quality || format == "ply", "--quality", "with --to ply");
    require(options.animate == standard.animate || format == "glb", "--animate", "with --to glb");
    require(!options.voxel || format == "vdb", "--voxel", "with --to vdb");
    const bool cache = format == "pc2" || format == "mdd";
    require(!options.slow.factor || cache || format == "glb", "--slow", "with --to glb, pc2 and mdd");
    require(!options.slow.rate || cache, "--rate", "with --to pc2 and mdd");
    require(!options.thickness || options.solid || format == "vdb" || format == "fragments", "--thickness",
            "with --solid, --to fragments or vdb");
}

}  // namespace

void add_obstacle_files(ExportSource& source, std::size_t frame, const std::string& extension,
                        MeshContent content, std::vector<ExportJob>& jobs) {
    for (std::size_t i = 0; i < source.obstacles().size(); ++i) {
        const std::filesystem::path file = source.frame_file(frame, source.obstacle_suffix(i, extension));
        jobs.push_back(
            {file, [&source, i, frame, file, content] { return content(source.obstacle(i, frame), file); }});
    }
}

std::string export_format_names() {
    return names_where(nullptr);
}

const ExportFormat& export_format(const ExportOptions& options) {
    const auto format = std::ranges::find(formats, options.format, &ExportFormat::name);
    if (format == formats.end())
        throw Error(fmt::format("--to {}: there is no such format; give one of {}", options.format,
                                export_format_names()));
    check_option(*format, options.fragments, "--fragments", &ExportFormat::fragments);
    check_option(*format, options.solid, "--solid", &ExportFormat::solid);
    check_values(options);
    check_use(options, {});
    return *format;
}

}  // namespace sherd
