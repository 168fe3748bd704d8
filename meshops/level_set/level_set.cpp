// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshops/level_set/level_set.h"

#include <openvdb/openvdb.h>
#include <openvdb/tools/ChangeBackground.h>
#include <openvdb/tools/Composite.h>
#include <openvdb/tools/MeshToVolume.h>

#include <Eigen/Geometry>
#include <fstream>
#include <map>

#include "meshops/error.h"
#include "meshops/level_set/float_grid.h"

namespace sherd {

namespace {

/// Width, in voxels, of the layer on each side of a surface in which a level set has distances.
constexpr float band = 3;
constexpr const char* grid_name = "surface";
/// Difference in thickness that is neglected, in voxels. Without it, each triangle of a sheet of varying
/// thickness would need a grid of its own.
constexpr double negligible = 0.01;

using Triangles = std::vector<openvdb::Vec3I>;

/// Returns the triangles of each thickness (m). Thicknesses that differ by at most `alike` (m) count as the
/// smallest of them.
std::map<double, Triangles> triangles_by_thickness(const TriangleSheet& sheet,
                                                   std::span<const double> thickness, double alike) {
    std::map<double, Triangles> exactly, result;
    for (std::size_t t = 0; t < sheet.triangles.size(); ++t) {
        const auto& [a, b, c] = sheet.triangles[t];
        exactly[thickness[t]].emplace_back(a, b, c);
    }
    for (auto& [value, triangles] : exactly) {
        if (result.empty() || value - result.rbegin()->first > alike) result[value];
        Triangles& all = result.rbegin()->second;
        all.insert(all.end(), triangles.begin(), triangles.end());
    }
    return result;
}

openvdb::FloatGrid::Ptr level_set_of(const std::vector<openvdb::Vec3s>& points, const Triangles& triangles,
                                     double thickness, double voxel) {
    const auto transform = openvdb::math::Transform::createLinearTransform(voxel);
    const auto half = static_cast<float>(thickness / 2);
    const auto reach = static_cast<float>(half / voxel) + band;
    auto grid = openvdb::tools::meshToUnsignedDistanceField<openvdb::FloatGrid>(*transform, points, triangles,
                                                                                {}, reach);
    for (auto value = grid->beginValueOn(); value; ++value) value.setValue(*value - half);
    openvdb::tools::changeBackground(grid->tree(), band * static_cast<float>(voxel));
    return grid;
}

/// Replaces the random UUID that OpenVDB gives each file, so that equal grids give equal files. In the file
/// it follows the magic number, three version numbers and a flag.
void replace_random_name(const std::filesystem::path& file) {
    constexpr std::streamoff place = 8 + 3 * 4 + 1;
    std::fstream stream(file, std::ios::binary | std::ios::in | std::ios::out);
    stream.seekp(place);
    stream << "00000000-0000-4000-8000-000000000000" << std::flush;
}

/// Reads the last grid of the file to check that the file is complete, since OpenVDB does not notice a full
/// disk.
void check_complete(const std::filesystem::path& file, const std::string& last_grid) {
    try {
        sample_float_grid(file, last_grid, {});
    } catch (const Error&) {
        throw Error(
            file.string() + ": cannot be written: no room on the disk, or a limit on the size of files",
            Fault::run);
    }
}

std::vector<openvdb::Vec3s> points_of(const TriangleSheet& sheet) {
    std::vector<openvdb::Vec3s> points;
    for (const auto& p : sheet.points)
        points.emplace_back(static_cast<float>(p.x()), static_cast<float>(p.y()), static_cast<float>(p.z()));
    return points;
}

openvdb::FloatGrid::Ptr thickened_grid(const TriangleSheet& sheet, std::span<const double> thickness,
                                       double voxel) {
    const std::vector<openvdb::Vec3s> points = points_of(sheet);
    openvdb::FloatGrid::Ptr whole;
    for (const auto& [value, triangles] : triangles_by_thickness(sheet, thickness, negligible * voxel)) {
        const openvdb::FloatGrid::Ptr part = level_set_of(points, triangles, value, voxel);
        if (whole)
            openvdb::tools::csgUnion(*whole, *part);
        else
            whole = part;
    }
    return whole;
}

openvdb::FloatGrid::Ptr body_grid(const LevelSetBody& body) {
    Triangles triangles;
    for (const auto& [a, b, c] : body.surface.triangles) triangles.emplace_back(a, b, c);
    return openvdb::tools::meshToLevelSet<openvdb::FloatGrid>(
        *openvdb::math::Transform::createLinearTransform(body.voxel), points_of(body.surface), triangles,
        band);
}

}  // namespace

double expected_voxels(const TriangleSheet& sheet, std::span<const double> thickness, double voxel) {
    double volume = 0;
    for (std::size_t t = 0; t < sheet.triangles.size(); ++t) {
        const auto& [a, b, c] = sheet.triangles[t];
        const Eigen::Vector3d e = sheet.points[b] - sheet.points[a], f = sheet.points[c] - sheet.points[a];
        volume += e.cross(f).norm() / 2 * (thickness[t] + 2 * band * voxel);
    }
    return volume / (voxel * voxel * voxel);
}

void write_level_set(const TriangleSheet& sheet, std::span<const double> thickness, double voxel,
                     std::span<const LevelSetBody> bodies, const std::filesystem::path& file) try {
    openvdb::initialize();
    openvdb::GridPtrVec grids;
    const auto add = [&](const openvdb::FloatGrid::Ptr& grid, const std::string& name) {
        grid->setName(name);
        grid->setGridClass(openvdb::GRID_LEVEL_SET);
        grid->setSaveFloatAsHalf(false);
        grids.push_back(grid);
    };
    add(thickened_grid(sheet, thickness, voxel), grid_name);
    for (const LevelSetBody& body : bodies) add(body_grid(body), body.name);
    openvdb::io::File(file.string()).write(grids);
    replace_random_name(file);
    check_complete(file, grids.back()->getName());
} catch (const openvdb::Exception& error) {
    throw Error(file.string() + ": cannot be written: " + error.what(), Fault::run);
}

}  // namespace sherd
