// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "core/contact/detection/cached_trees.h"
#include "core/contact/detection/pair_blocks.h"
#include "core/state_visitor.h"

namespace sherd {

/// Candidate pairs: elements of a surface that come near contact somewhere in a neighbourhood. Finding them
/// is most of the cost of contact. Finding the active ones among them is cheap, since most are farther apart
/// than their vertices have moved.
class ContactCandidates {
  public:
    /// Two elements are near when they are closer than this multiple of the activation distance.
    static constexpr double nearness = 1.15;

    /// No pairs. threads: share the search for pairs and queries of them.
    explicit ContactCandidates(Threads threads = Threads()) : threads(std::move(threads)) {}
    /// cached: trees that are reused by the next call, for the same surface.
    ContactCandidates(const ContactSurface& surface, Neighbourhood neighbourhood, CachedTrees& cached,
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
    /// Searches pairs again where triangles have other vertices or another place on the sheet, or where the
    /// exemptions of vertices (exempt_pairs(), near_vertices(), is_surface_exempt()) have changed.
    void follow(const ShellChange& change, const ContactSurface& before, const ContactSurface& after,
                CachedTrees& cached);

    void visit_state(StateVisitor& visit) {
        auto& [within, pairs, threads] = *this;
        visit(within, pairs);
    }

  private:
    /// Searches all pairs with a vertex that has changed.
    void find(const ContactSurface& surface, const std::vector<char>& changed, CachedTrees& cached);
    /// Two elements whose boxes overlap.
    struct ElementPair {
        PairKind kind;
        std::array<Index, 4> vertices;
    };
    /// Call take(met) for two elements whose boxes overlap and of which one has a vertex that has changed.
    template <class Take>
    void meet_on_sheets(const ContactSurface& surface, const std::vector<char>& changed, CachedTrees& cached,
                        const Take& take) const;
    template <class Take>
    void meet_on_colliders(const ContactSurface& surface, const std::vector<char>& changed,
                           ColliderTrees& colliders, const Take& take) const;
    /// The pair of two elements; none if they do not come near contact.
    std::optional<PairBlocks::Entry> pair_of(const ContactSurface& surface,
                                             const ElementPair& touching) const;

    Neighbourhood within;
    PairBlocks pairs;
    Threads threads;
};

}  // namespace sherd
