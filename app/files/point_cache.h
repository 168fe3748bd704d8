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

// Point caches hold the places of the same points at several times: a head, and then three floats of each
// point of each sample.

inline constexpr std::endian pc2_order = std::endian::little, mdd_order = std::endian::big;

/// The head of a .pc2 file (of 3ds Max and Blender): name, version, points, first frame, frames a sample and
/// samples. The first frame is 0, and each sample is one frame later.
std::string pc2_head(std::size_t points, std::size_t samples);
/// The head of an .mdd file (of LightWave): samples, points and the samples' times, s.
std::string mdd_head(std::size_t points, std::span<const double> times);

struct PointCache {
    std::vector<double> times;              ///< s, ascending, from 0
    std::vector<Eigen::Matrix3Xf> samples;  ///< [3, P] at each of these times, in the unit of the file
};

/// Frames of a .pc2 file in a second, unless the user says otherwise.
inline constexpr double default_frame_rate = 24;

/// Reads a .pc2 or .mdd file of so many points, those of `mesh`. frame_rate: frames of a .pc2 file in a
/// second, or samples of an .mdd file in place of its times. Throws Error naming the file if it is missing,
/// unreadable, of another kind or damaged, on NaN and infinite coordinates, and on another number of points;
/// memory is taken only when the file is as large as its head says.
PointCache read_point_cache(const std::filesystem::path& file, std::size_t points,
                            const std::filesystem::path& mesh, std::optional<double> frame_rate = {});

}  // namespace sherd
