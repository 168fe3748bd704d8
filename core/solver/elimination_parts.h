// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/solver/supernodes.h"

namespace sherd {

/// Consecutive supernodes, of whole subtrees, which can be eliminated in parallel with other parts.
struct EliminationPart {
    Index first = 0, end = 0;             ///< supernodes
    Index first_column = 0, columns = 0;  ///< consecutive columns of these supernodes
    std::vector<Index> outside;           ///< rows of these supernodes after these columns, ascending
};

/// Division of a factor's supernodes among threads: parts in parallel, then the supernodes above, one by one.
struct EliminationParts {
    explicit EliminationParts(const Supernodes& pattern);

    std::vector<EliminationPart> parts;
    std::vector<Index> above;    ///< supernodes, ascending
    std::vector<char> is_above;  ///< [S]
    /// For each entry of Supernodes::row its index in a vector with the columns of its part and then the rows
    /// outside; for supernodes above, in a vector of all rows.
    std::vector<Index> place;
};

}  // namespace sherd
