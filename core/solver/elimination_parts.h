// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/solver/supernodes.h"

namespace sherd {

/// Supernodes in sequence, of whole subtrees, which can be eliminated while others are.
struct EliminationPart {
    Index first = 0, end = 0;             ///< supernodes
    Index first_column = 0, columns = 0;  ///< theirs, which follow each other
    std::vector<Index> outside;           ///< the rows of theirs that come after these columns, ascending
};

/// How the supernodes of a factor are shared: parts beside each other, then what is above them, one by one.
struct EliminationParts {
    explicit EliminationParts(const Supernodes& pattern);

    std::vector<EliminationPart> parts;
    std::vector<Index> above;    ///< supernodes, ascending
    std::vector<char> is_above;  ///< [S]
    /// Of each of Supernodes::row where it is in a vector with the columns of its part and then its rows
    /// outside; of supernodes above in a vector of all rows.
    std::vector<Index> place;
};

}  // namespace sherd
