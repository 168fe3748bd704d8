// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>

#include "core/vector.h"

namespace sherd {

/// Role of a vertex for paths.
enum class PathRole : std::uint8_t {
    none,  ///< no path visits it
    begin,
    between,
    end
};

/// Returns the largest number of paths over `edges`, from a vertex `begin` to a vertex `end`, that share no
/// edge: the maximum flow, by shortest augmenting paths (Edmonds and Karp 1972). It is also the smallest
/// number of edges that separate all beginnings from all ends (Menger 1927). roles: of each vertex that an
/// edge has.
std::size_t disjoint_paths(std::span<const std::array<Index, 2>> edges, std::span<const PathRole> roles);

}  // namespace sherd
