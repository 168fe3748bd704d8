// SPDX-License-Identifier: GPL-3.0-or-later
// OpenVDB's headers take long to compile: only sources that need its grids may include this header.
#pragma once

#include <openvdb/openvdb.h>

#include <filesystem>
#include <string>

namespace sherd {

/// Reads the float grid `name` of an OpenVDB file; an empty name stands for the only float grid. Throws Error
/// naming the file if it is missing, damaged or no OpenVDB file, or has no such grid.
openvdb::FloatGrid::Ptr read_float_grid(const std::filesystem::path& file, const std::string& name);

}  // namespace sherd
