// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <openvdb/io/File.h>
#include <openvdb/openvdb.h>

#include <filesystem>
#include <string>

namespace sherd::test {

/// OpenVDB grid of cubic voxels with sides of `voxel`, m. Voxels whose numbers are in the box `active` are
/// active, and have the value value(x, y, z) at their centre in space.
template <class Value>
openvdb::FloatGrid::Ptr vdb_grid(const std::string& name, double voxel, const openvdb::CoordBBox& active,
                                 float background, const Value& value) {
    openvdb::initialize();
    // Creates the grid by the name of its type: Grid::create would compile all of OpenVDB's tree a second
    // time.
    auto grid = openvdb::gridPtrCast<openvdb::FloatGrid>(
        openvdb::GridBase::createGrid(openvdb::FloatGrid::gridType()));
    grid->tree().root().setBackground(background, false);
    grid->setName(name);
    grid->setTransform(openvdb::math::Transform::createLinearTransform(voxel));
    for (auto at = active.begin(); at; ++at) {
        const openvdb::Vec3d place = grid->indexToWorld(*at);
        grid->tree().setValue(*at, static_cast<float>(value(place.x(), place.y(), place.z())));
    }
    return grid;
}

inline std::filesystem::path write_vdb(const std::filesystem::path& file, const openvdb::GridPtrVec& grids) {
    openvdb::io::File(file.string()).write(grids);
    return file;
}

}  // namespace sherd::test
