// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>

namespace sherd::hdf5 {

/// Throws Error if a block that HDF5 is about to read is a collection of its global heap, which stores texts,
/// and has lengths that do not fit into it: with these HDF5 1.10 loops for ever, or reads elsewhere.
/// Everything else that HDF5 reads of a recording has checksums. ("HDF5 File Format Specification", version
/// 3, III.E; 8-byte lengths.)
void require_sound_heap(std::span<const std::byte> block);

}  // namespace sherd::hdf5
