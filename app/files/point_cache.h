// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <bit>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace sherd {

// Point caches store the positions of the same points at several times: a header, and then three floats for
// each point of each sample.

inline constexpr std::endian pc2_order = std::endian::little, mdd_order = std::endian::big;

/// Returns the header of a .pc2 file (of 3ds Max and Blender): name, version, number of points, first frame,
/// frames per sample, number of samples. The first frame is 0, and each sample is one frame later.
std::string pc2_head(std::size_t points, std::size_t samples);
/// Returns the header of an .mdd file (of LightWave): number of samples, number of points and the samples'
/// times, s.
std::string mdd_head(std::size_t points, std::span<const double> times);

struct PointCache {
    std::vector<double> times;              ///< s, time of each sample, ascending from 0
    std::vector<Eigen::Matrix3Xf> samples;  ///< [3, P] positions of P points each, in the unit of the file
};

/// Default number of frames of a .pc2 file per second.
inline constexpr double default_frame_rate = 24;

/// Reads a .pc2 or .mdd file, which must have `points` points, one for each vertex of the mesh in the file
/// `mesh`. frame_rate: for a .pc2 file, its frames per second, default_frame_rate if none; for an .mdd file,
/// samples per second, which replace the times in the file unless none. Throws Error naming the file if it is
/// missing, unreadable, of another kind or damaged, has NaN or infinite coordinates, or has another number of
/// points. Memory is allocated only if the file is as large as its header claims.
PointCache read_point_cache(const std::filesystem::path& file, std::size_t points,
                            const std::filesystem::path& mesh, std::optional<double> frame_rate = {});

}  // namespace sherd
