// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshops/level_set/float_grid.h"

#include <openvdb/tools/Interpolation.h>

#include <cmath>

#include "meshops/level_set/vdb_file.h"

namespace sherd {
namespace {

/// Whether the indices of the voxels around `place`, given in voxels, fit into their integer type; the
/// transform of a damaged file may give any place.
bool has_voxels_around(const openvdb::Vec3d& place) {
    constexpr double most = 1 << 30;
    return std::abs(place.x()) < most && std::abs(place.y()) < most && std::abs(place.z()) < most;
}

}  // namespace

GridSamples sample_float_grid(const std::filesystem::path& file, const std::string& name,
                              std::span<const Eigen::Vector3d> points) {
    const auto grid = read_float_grid(file, name);
    const auto voxels = grid->getConstAccessor();
    GridSamples samples;
    samples.background = grid->background();
    for (const Eigen::Vector3d& point : points) {
        const auto place = grid->transform().worldToIndex({point.x(), point.y(), point.z()});
        float value = 0;
        const bool active =
            has_voxels_around(place) && openvdb::tools::BoxSampler::sample(voxels, place, value);
        samples.outside += !active;
        samples.values.push_back(active ? static_cast<double>(value) : samples.background);
    }
    return samples;
}

}  // namespace sherd
