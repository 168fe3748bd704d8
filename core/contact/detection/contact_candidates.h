// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "core/contact/detection/kept_trees.h"
#include "core/contact/detection/pair_blocks.h"
#include "core/state_visitor.h"

namespace sherd {

/// The pairs of a surface's elements that come near contact somewhere in a neighbourhood. Finding them is
/// most of the cost of contact. Asking which of them are active is cheap: most have more room than they need.
class ContactCandidates {
  public:
    /// Two elements are near when they are closer than this multiple of the activation distance.
    static constexpr double nearness = 1.15;

    /// None. threads: who shares the search for pairs, and what is asked of them.
    explicit ContactCandidates(Threads threads = Threads()) : threads(std::move(threads)) {}
    /// kept: from one call to the next, for the same surface.
    ContactCandidates(const ContactSurface& surface, Neighbourhood neighbourhood, KeptTrees& kept,
                      Threads threads = Threads());

    const Neighbourhood& neighbourhood() const { return within; }
    /// The active pairs at x in the neighbourhood, ascending, vertex-triangle pairs first.
    std::vector<ContactPair> active(const ContactSurface& surface, const Positions& x) {
        return pairs.find_active(surface, x, within.round_off, threads);
    }
    /// Returns a superset of the pairs that come near contact somewhere in `smaller`, which must lie in the
    /// neighbourhood. They are ascending, vertex-triangle pairs first.
    std::vector<ContactPair> pick(const ContactSurface& surface, const Neighbourhood& smaller) const;
    /// See PairBlocks. x, and the ends of the motion, must lie in the neighbourhood.
    template <class Keep>
    std::vector<ContactPair> near(const Positions& x, const Positions& motion, double as_near, double reserve,
                                  const Keep& keep) const {
        return pairs.near(x, motion, as_near, reserve + within.round_off, threads, keep);
    }
    /// Searches pairs again where triangles have other vertices or another place on the sheet, or where
    /// vertices gained or lost twins or others that are near since the start.
    void follow(const ShellChange& change, const ContactSurface& before, const ContactSurface& after,
                KeptTrees& kept);

    void visit_state(StateVisitor& visit) {
        auto& [within, pairs, threads] = *this;
        visit(within, pairs);
    }

  private:
    /// Searches all pairs with a vertex that has changed.
    void find(const ContactSurface& surface, const std::vector<char>& changed, KeptTrees& kept);
    /// Two elements whose boxes overlap.
    struct Met {
        PairKind kind;
        std::array<Index, 4> vertices;
    };
    /// Call take(met) for those of which one has a vertex that has changed.
    template <class Take>
    void meet_on_sheets(const ContactSurface& surface, const std::vector<char>& changed, KeptTrees& kept,
                        const Take& take) const;
    template <class Take>
    void meet_on_colliders(const ContactSurface& surface, const std::vector<char>& changed,
                           ColliderTrees& colliders, const Take& take) const;
    /// The pair that they are, if they come near contact.
    std::optional<PairBlocks::Entry> pair_of(const ContactSurface& surface, const Met& met) const;

    Neighbourhood within;
    PairBlocks pairs;
    Threads threads;
};

}  // namespace sherd
