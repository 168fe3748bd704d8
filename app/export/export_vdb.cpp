// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>

#include "app/export/export_formats.h"
#include "app/export/export_sheet.h"
#include "meshops/error.h"
#include "meshops/level_set.h"

namespace sherd {

namespace {

/// Some gigabytes of memory.
constexpr double most_voxels = 3e8;

/// m; throws Error (input) when the sheets would have holes or the grid be too large.
double voxel_size(ExportSource& source) {
    const Snapshot& first = source.frame(source.frames().front());
    const std::vector<double> thickness = source.thickness(first);
    const double thinnest = *std::ranges::min_element(thickness);
    const double voxel = source.options.voxel.value_or(thinnest / 4);
    if (voxel > thinnest / 2)
        throw Error(
            fmt::format("--voxel {:g}: a sheet {:g} m thick would have holes; give at most half of that",
                        voxel, thinnest));
    const double voxels = expected_voxels(frame_sheet(first), thickness, voxel);
    if (voxels > most_voxels)
        throw Error(fmt::format(
            "voxels of {:g} m: a frame would fill {:.2g} of them, the most is {:.2g}; give a larger "
            "--voxel (up to half the thickness, {:g} m)",
            voxel, voxels, most_voxels, thinnest / 2));
    return voxel;
}

}  // namespace

std::vector<ExportJob> plan_vdb(ExportSource& source) {
    const double voxel = voxel_size(source);
    std::vector<ExportJob> jobs;
    for (const std::size_t number : source.frames())
        jobs.push_back({source.frame_file(number, ".vdb"), nullptr,
                        [&source, number, voxel](const std::filesystem::path& file) {
                            const Snapshot& frame = source.frame(number);
                            write_level_set(frame_sheet(frame), source.thickness(frame), voxel, file);
                        }});
    return jobs;
}

}  // namespace sherd
