// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/vector.h"

namespace sherd {

/// The positions that depart from some moment of a straight motion by no more than a margin at each vertex,
/// but for what moves all vertices alike, which changes no distance. It is convex: what holds the ends of a
/// straight motion holds all of it.
class Neighbourhood {
  public:
    Neighbourhood() = default;
    /// x, motion: [3, V] m; margin: m.
    Neighbourhood(const Positions& x, const Positions& motion, double margin);

    bool contains(const Positions& x) const { return contains(x, 0); }
    bool contains(const Neighbourhood& other) const;

    Positions start;       ///< [3, V] m
    Positions motion;      ///< [3, V] m, less what it moves all vertices by
    double margin = 0;     ///< m
    double round_off = 0;  ///< m, far above that of any distance here

  private:
    bool contains(const Positions& x, double spare) const;
};

}  // namespace sherd
