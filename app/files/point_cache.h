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

/// Returns the header of a .pc2 file (of 3ds Max and Blender): name, version, points, first frame, frames a
/// sample and samples. The first frame is 0, and each sample is one frame later.
std::string pc2_head(std::size_t points, std::size_t samples);
/// Returns the header of an .mdd file (of LightWave): samples, points and the samples' times, s.
std::string mdd_head(std::size_t points, std::span<const double> times);

struct PointCache {
    std::vector<double> times;              ///< s, ascending, from 0
    std::vector<Eigen::Matrix3Xf> samples;  ///< [3, P] at each time, in the unit of the file
};

/// Frames of a .pc2 file per second, by default.
inline constexpr double default_frame_rate = 24;

/// Reads a .pc2 or .mdd file with `points` points, as many as `mesh` has vertices. frame_rate: frames of a
/// .pc2 file per second, or samples of an .mdd file in place of its times. Throws Error naming the file if it
/// is missing, unreadable, of another kind or damaged, on NaN and infinite coordinates, and on another number
/// of points. Memory is allocated only if the file is as large as its header claims.
PointCache read_point_cache(const std::filesystem::path& file, std::size_t points,
                            const std::filesystem::path& mesh, std::optional<double> frame_rate = {});

}  // namespace sherd
