// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/contact/detection/collider_trees.h"
#include "core/contact/detection/pair_blocks.h"
#include "core/state_visitor.h"

namespace sherd {

/// The pairs of a surface's elements that come near contact somewhere in a neighbourhood. Finding them is
/// most of the cost of contact. Asking which of them are active is cheap: most have more room than they need.
class ContactCandidates {
  public:
    /// Two elements are near when they are closer than this multiple of the activation distance.
    static constexpr double nearness = 1.15;

    ContactCandidates() = default;
    /// colliders: the trees of the colliders, kept from one call to the next.
    ContactCandidates(const ContactSurface& surface, Neighbourhood neighbourhood, ColliderTrees& colliders);

    const Neighbourhood& neighbourhood() const { return within; }
    /// The active pairs at x in the neighbourhood, ascending, vertex-triangle pairs first.
    void find_active(const ContactSurface& surface, const Positions& x, std::vector<ContactPair>& active) {
        pairs.find_active(surface, x, within.round_off, active);
    }
    /// Returns a superset of the pairs that come near contact somewhere in `smaller`, which must lie in the
    /// neighbourhood. They are ascending, vertex-triangle pairs first.
    std::vector<ContactPair> pick(const ContactSurface& surface, const Neighbourhood& smaller) const;
    /// See PairBlocks. x, and the ends of the motion, must lie in the neighbourhood.
    template <class Visit>
    void visit_near(const Positions& x, const Positions& motion, double as_near, double reserve,
                    const Visit& visit) const {
        pairs.visit_near(x, motion, as_near, reserve + within.round_off, visit);
    }
    /// Searches pairs again where triangles have other vertices or another place on the sheet, or where
    /// vertices gained or lost twins or others that are near since the start.
    void follow(const ShellChange& change, const ContactSurface& before, const ContactSurface& after,
                ColliderTrees& colliders);

    void visit_state(StateVisitor& visit) {
        auto& [within, pairs] = *this;
        visit(within, pairs);
    }

  private:
    /// Searches all pairs with a vertex that has changed.
    void find(const ContactSurface& surface, const std::vector<char>& changed, ColliderTrees& colliders);
    using Found = std::vector<PairBlocks::Entry>;
    void find_on_sheets(const ContactSurface& surface, const std::vector<char>& changed, Found& found) const;
    void find_on_colliders(const ContactSurface& surface, const std::vector<char>& changed,
                           ColliderTrees& colliders, Found& found) const;
    void consider(const ContactSurface& surface, PairKind kind, const std::array<Index, 4>& vertices,
                  Found& found) const;

    Neighbourhood within;
    PairBlocks pairs;
};

}  // namespace sherd
