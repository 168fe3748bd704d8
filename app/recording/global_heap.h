// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>

namespace sherd::hdf5 {

/// Checks a block that HDF5 is about to read, if it is one of its global heap, which holds texts: with
/// lengths that do not fit into it HDF5 1.10 goes on for ever, or reads elsewhere. All else that it reads of
/// a recording has checksums. ("HDF5 File Format Specification", version 3, III.E; 8-byte lengths.) Throws
/// Error.
void require_sound_heap(std::span<const std::byte> block);

}  // namespace sherd::hdf5
