// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>

namespace sherd::hdf5 {

/// Throws Error if `block`, which HDF5 is about to receive from a file, is a damaged collection of HDF5's
/// global heap, which stores texts: a collection with lengths that do not fit into it. With such lengths
/// HDF5 1.10 loops for ever, or reads outside of the block. All other metadata of a recording have checksums.
/// ("HDF5 File Format Specification", version 3, III.E; 8-byte lengths.)
void require_sound_heap(std::span<const std::byte> block);

}  // namespace sherd::hdf5
