// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "app/recording/hdf5.h"

namespace sherd::recording_format {

/// Returns the number of rows of each table of a recording.
std::vector<std::size_t> extent(hid_t file);

/// Truncates the file to `frames` frames, and to `rows` rows of each table. Throws Error (run) if it holds
/// less.
void cut(hid_t file, std::size_t frames, std::span<const std::size_t> rows);

}  // namespace sherd::recording_format
