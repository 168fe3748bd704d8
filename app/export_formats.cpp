// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/export_formats.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "meshops/error.h"

namespace sherd {

namespace {

constexpr std::array<ExportFormat, 8> formats{{
    {"obj", ".obj", false, true, true, plan_obj},
    {"ply", ".ply", false, true, true, plan_ply},
    {"stl", ".stl", false, true, true, plan_stl},
    {"pvd", ".pvd", true, false, false, plan_pvd},
    {"pc2", ".pc2", true, false, true, plan_pc2},
    {"mdd", ".mdd", true, false, true, plan_mdd},
    {"glb", ".glb", true, true, true, plan_glb},
    {"vdb", ".vdb", false, false, true, plan_vdb},
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
        throw Error(fmt::format("--to {} does not know {}; {} do", format.name, option, names_where(known)));
}

void check_values(const ExportOptions& options) {
    constexpr std::array qualities{"strain", "speed", "fragment"};
    if (std::ranges::find(qualities, options.quality) == qualities.end())
        throw Error(fmt::format("--quality {}: there is no such quantity; give strain, speed or fragment",
                                options.quality));
    if (options.animate != "rigid" && options.animate != "morph")
        throw Error(fmt::format("--animate {}: there is no such way; give rigid or morph", options.animate));
    if (options.voxel && !(*options.voxel > 0 && std::isfinite(*options.voxel)))
        throw Error(fmt::format("--voxel {}: give a size in m, above 0", *options.voxel));
    if (options.thickness && !(*options.thickness > 0 && std::isfinite(*options.thickness)))
        throw Error(fmt::format("--thickness {}: give a thickness in m, above 0", *options.thickness));
}

}  // namespace

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
    return *format;
}

}  // namespace sherd
