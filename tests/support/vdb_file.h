// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <openvdb/io/File.h>
#include <openvdb/openvdb.h>

#include <filesystem>
#include <string>

namespace sherd::test {

/// A grid of cubic voxels whose centres in [lower, upper] (numbers of voxels) are active and hold
/// `value(x, y, z)` of their place in space.
template <class Grid = openvdb::FloatGrid, class Value>
typename Grid::Ptr vdb_grid(const std::string& name, double voxel, const openvdb::CoordBBox& active,
                            typename Grid::ValueType background, const Value& value) {
    openvdb::initialize();
    const typename Grid::Ptr grid = Grid::create(background);
    grid->setName(name);
    grid->setTransform(openvdb::math::Transform::createLinearTransform(voxel));
    auto voxels = grid->getAccessor();
    for (auto at = active.begin(); at; ++at) {
        const openvdb::Vec3d place = grid->indexToWorld(*at);
        voxels.setValue(*at, static_cast<typename Grid::ValueType>(value(place.x(), place.y(), place.z())));
    }
    return grid;
}

inline std::filesystem::path write_vdb(const std::filesystem::path& file, const openvdb::GridPtrVec& grids) {
    openvdb::io::File(file.string()).write(grids);
    return file;
}

}  // namespace sherd::test
