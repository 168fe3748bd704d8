// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <set>

#include "core/contact/detection/contact_candidates.h"

namespace sherd {

/// The pairs of a surface that touch, for positions that come one after the other. What was found is kept as
/// long as it holds; no answer depends on what was asked before. Positions are those of all vertices of the
/// surface, [3, surface().vertices()] m.
class NearPairs {
  public:
    explicit NearPairs(ContactSurface surface) : of(std::move(surface)) {}
    /// Goes on with a surface that has new vertices at its end, other triangles or other twins.
    void surface_changed(ContactSurface surface);
    const ContactSurface& surface() const { return of; }

    /// The pairs that push at x, vertices with triangles first, ascending. Valid until the next call.
    const std::vector<ContactPair>& touching(const Positions& x) const;
    /// Fraction, 0 to 1, of a straight motion from x up to which no pair comes as near as its minimum.
    double safe_fraction(const Positions& x, const Positions& motion) const;
    /// Pairs among which are all that touch between x and x + motion. Valid until the next call.
    const std::vector<ContactPair>& candidates(const Positions& x, const Positions& motion) const;
    /// Appends the pairs of sheets' vertices that have a block in a Hessian at x, numbered as in a sheet;
    /// `ahead`: those of pairs that may touch soon.
    void add_contacts(const Positions& x, bool ahead, std::vector<std::pair<Index, Index>>& pairs) const;

    /// Adds the sheets' vertices of pairs with solids that push at x, numbered as in a sheet, and the solids.
    void add_touched(const Positions& x, std::set<Index>& vertices,
                     std::set<const SolidSurface*>& touched) const;

  private:
    ContactSurface of;
    // Kept to save time; no result depends on them.
    mutable SolidTrees solids;
    mutable ContactCandidates found;          ///< for some time to come
    mutable Neighbourhood near;               ///< where the step is about
    mutable std::vector<ContactPair> pairs;   ///< that may touch there
    mutable Positions last;                   ///< where the touching pairs were last asked for, m
    mutable std::vector<ContactPair> active;  ///< the answer
};

}  // namespace sherd
