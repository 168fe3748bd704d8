// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>

#include "core/vector.h"

namespace sherd {

/// What a vertex is to paths.
enum class PathRole : std::uint8_t {
    none,  ///< no path goes there
    begin,
    between,
    end
};

/// The most paths over `edges` from a vertex to begin at to one to end at that share no edge: the maximum
/// flow, by shortest augmenting paths (Edmonds and Karp 1972). So as many edges, and not fewer, part all
/// beginnings from all ends (Menger 1927). roles: of each vertex that an edge has.
std::size_t disjoint_paths(std::span<const std::array<Index, 2>> edges, std::span<const PathRole> roles);

}  // namespace sherd
