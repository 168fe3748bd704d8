// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>

#include "core/vector.h"

namespace sherd {

/// Role of a vertex for disjoint_paths().
enum class PathRole : std::uint8_t {
    none,  ///< no path visits it
    begin,
    between,
    end
};

/// Returns the largest number of paths along `edges`, from a `begin` vertex to an `end` vertex, no two of
/// which share an edge. The number is the maximum flow, found by shortest augmenting paths (Edmonds and Karp
/// 1972). It is also the smallest number of edges that separate all `begin` from all `end` vertices (Menger
/// 1927). roles: role of each vertex, by its number in `edges`.
std::size_t disjoint_paths(std::span<const std::array<Index, 2>> edges, std::span<const PathRole> roles);

}  // namespace sherd
