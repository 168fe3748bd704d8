// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/vector.h"

namespace sherd {

/// The positions that depart from some moment of a straight motion by no more than a margin at each vertex.
/// Without solids, what moves all vertices alike does not count: it changes no distance. It is convex: what
/// holds the ends of a straight motion holds all of it.
class Neighbourhood {
  public:
    Neighbourhood() = default;
    /// x, motion: [3, V] m, the first `solids` vertices being those of solids; margin: m.
    Neighbourhood(const Positions& x, const Positions& motion, double margin, Index solids = 0);

    bool contains(const Positions& x) const { return contains(x, 0); }
    bool contains(const Neighbourhood& other) const;

    Positions start;       ///< [3, V] m
    Positions motion;      ///< [3, V] m; without solids, less what it moves all vertices by
    double margin = 0;     ///< m
    double round_off = 0;  ///< m, far above that of any distance here

  private:
    bool contains(const Positions& x, double spare) const;

    Index solids = 0;
    bool solids_rest = true;  ///< so that they need not be looked at one by one
};

}  // namespace sherd
