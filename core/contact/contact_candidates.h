// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/contact/contact_surface.h"

namespace sherd {

/// The pairs of a surface's elements that may touch somewhere along a straight motion, or a little beside it.
/// They say the same about every position that they cover, however they were found: pairs come in ascending
/// order, and those too many have no energy.
class ContactCandidates {
  public:
    ContactCandidates() = default;
    /// x, motion: [3, V] m.
    ContactCandidates(const ContactSurface& surface, const Positions& x, const Positions& motion);

    /// Whether all pairs that touch at x are among them. If it is so for both ends of a motion, then all
    /// along it.
    bool cover(const Positions& x) const;
    const std::vector<ContactPair>& pairs() const { return pair; }

  private:
    void add(const ContactPair& candidate);

    Positions start, motion;
    double margin = 0;  ///< m, by which every vertex may depart from the motion
    std::vector<ContactPair> pair;
};

}  // namespace sherd
