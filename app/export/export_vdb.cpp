// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <set>

#include "app/export/export_formats.h"
#include "app/export/export_sheet.h"
#include "meshops/error.h"
#include "meshops/level_set/level_set.h"

namespace sherd {

namespace {

/// Largest allowed number of voxels, which take some gigabytes of memory.
constexpr double most_voxels = 3e8;

/// Returns the size of the sheets' voxels, m. Throws Error (input) if the sheets would have holes with it, or
/// the grid would be too large.
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
        throw Error(
            fmt::format("voxels of {:g} m: a frame would fill {:.2g} of them, more than {:.2g}; give a "
                        "larger --voxel (up to half the thickness, {:g} m)",
                        voxel, voxels, most_voxels, thinnest / 2));
    return voxel;
}

/// Number of voxels along the diagonal of an obstacle's box; they are at least as large as the sheets' ones.
constexpr double voxels_along = 200;

bool is_closed(const GridSurface& surface) {
    std::set<std::array<std::int32_t, 2>> sides;
    for (const auto& [a, b, c] : surface.triangles) sides.insert({{a, b}, {b, c}, {c, a}});
    return std::ranges::all_of(sides, [&](const auto& side) { return sides.contains({side[1], side[0]}); });
}

/// Whether an obstacle has an inside, and so a level set. Warns if an obstacle other than a plane has none.
bool has_inside(ExportSource& source, const ExportObstacle& obstacle) {
    const bool closed = is_closed(obstacle.surface);
    if (!closed && !obstacle.plane)
        source.warnings.push_back(
            fmt::format("{} is not closed, so it has no level set in the .vdb", obstacle.name));
    return closed && !obstacle.plane;
}

/// The obstacles with the indices `chosen` in their places in a frame. voxel: size of the sheets' voxels, m.
std::vector<LevelSetBody> bodies_in(const ExportSource& source, std::size_t frame,
                                    const std::vector<std::size_t>& chosen, double voxel) {
    std::vector<LevelSetBody> bodies;
    for (const std::size_t i : chosen) {
        const ExportObstacle& obstacle = source.obstacles()[i];
        Eigen::AlignedBox3d box;
        for (const Vector3d& point : obstacle.surface.points) box.extend(point);
        bodies.push_back({obstacle.name, source.obstacle(i, frame),
                          std::max(voxel, box.diagonal().norm() / voxels_along)});
    }
    return bodies;
}

}  // namespace

std::vector<ExportJob> plan_vdb(ExportSource& source) {
    const double voxel = voxel_size(source);
    std::vector<std::size_t> solids;
    for (std::size_t i = 0; i < source.obstacles().size(); ++i)
        if (has_inside(source, source.obstacles()[i])) solids.push_back(i);
    std::vector<ExportJob> jobs;
    for (const std::size_t number : source.frames())
        jobs.push_back({source.frame_file(number, ".vdb"), nullptr,
                        [&source, number, voxel, solids](const std::filesystem::path& file) {
                            const Snapshot& frame = source.frame(number);
                            write_level_set(frame_sheet(frame), source.thickness(frame), voxel,
                                            bodies_in(source, number, solids, voxel), file);
                        }});
    return jobs;
}

}  // namespace sherd
