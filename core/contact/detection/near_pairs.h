// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <set>

#include "core/contact/detection/contact_candidates.h"
#include "core/state_visitor.h"

namespace sherd {

/// The active pairs of a surface for a sequence of positions. Results of the search are reused as long as
/// they are valid; no answer depends on earlier calls. Positions are those of all vertices of the surface,
/// [3, surface().vertices()] m.
class NearPairs {
  public:
    explicit NearPairs(ContactSurface surface, Threads threads = Threads())
        : of(std::move(surface)), threads(std::move(threads)), found(this->threads) {}
    /// Continues with a surface whose sheets, or their exempt vertices, have changed.
    void surface_changed(const ShellChange& change, ContactSurface surface);
    const ContactSurface& surface() const { return of; }

    /// The active pairs at x, ascending, vertex-triangle pairs first. They are valid until the next call.
    const std::vector<ContactPair>& active_pairs(const Positions& x) const;
    /// Fraction, 0 to 1, of a straight motion from x up to which every pair stays above its minimum distance;
    /// less where a vertex moves by more than 128 widths of triangles relative to the others.
    double safe_fraction(const Positions& x, const Positions& motion) const {
        return free_fraction(x, motion, Gap::minimum);
    }
    /// Whether middle surfaces pass through each other somewhere in a straight motion from x, whatever their
    /// thickness, or a vertex moves beyond the limit of safe_fraction().
    bool passes(const Positions& x, const Positions& motion) const {
        return free_fraction(x, motion, Gap::nothing) < 1;
    }
    /// Whether middle surfaces pass through each other on a path of `parts` straight parts; at(share):
    /// positions after a share of it.
    template <class At>
    bool passes_in_parts(int parts, const At& at) const {
        Positions before = at(0.0);
        for (int part = 1; part <= parts; ++part) {
            const Positions after = at(static_cast<double>(part) / parts);
            if (passes(before, after - before)) return true;
            before = after;
        }
        return false;
    }
    /// Sets the second spring of pairs that are springs, also of those found later.
    void set_second_spring(SecondSpring of_springs);
    SecondSpring second_spring() const { return spring_of_pairs; }
    /// The smallest distance of an active pair at x, as a share of its activation distance; 1 if there is
    /// none.
    double least_share(const Positions& x) const;
    /// Whether pairs at x that are springs could be barriers, with some of their range left.
    bool allow_barriers(const Positions& x) const;
    /// A superset of the pairs that are active at x, and of those that are nearer there than a tenth of the
    /// thinnest sheet's thickness, by a search of its own, which is not reused.
    std::vector<ContactPair> pairs_nearby(const Positions& x) const;
    /// Calls see(pair) for a superset of the pairs that pairs_nearby() finds anywhere between x and x +
    /// motion, several times for some of them; never where the motion exceeds the limit of safe_fraction().
    void each_nearby(const Positions& x, const Positions& motion,
                     const std::function<void(const ContactPair&)>& visit_pair) const;
    /// The pairs that may be active somewhere in a straight motion from x.
    std::vector<ContactPair> pairs_within_reach(const Positions& x, const Positions& motion) const;
    /// Appends the pairs of shell vertices, numbered as in the shell, that have a block in a Hessian at x;
    /// with `ahead`, of all pairs that are near (ContactCandidates::nearness).
    void add_contacts(const Positions& x, bool ahead, std::vector<std::pair<Index, Index>>& pairs) const;

    /// Adds the shell's vertices of pairs with colliders that are active at x, numbered as in the shell, and
    /// the surfaces of these colliders.
    void add_touched(const Positions& x, std::set<Index>& vertices,
                     std::set<const ColliderSurface*>& touched) const;

    /// Visits all but the trees, which follow from the positions.
    void visit_state(StateVisitor& visit) {
        auto& [of, threads, spring_of_pairs, trees, found, last, active] = *this;
        visit(of, spring_of_pairs, found, last, active);
    }

  private:
    void find(const Positions& x, const Positions& motion) const;
    /// The distance that pairs keep in a motion that counts as free: their minimum, or none.
    enum class Gap { minimum, nothing };
    double free_fraction(const Positions& x, const Positions& motion, Gap gap) const;
    double free_fraction_of_part(const Positions& x, const Positions& motion, Gap gap) const;
    /// Number of parts in which a motion is tested; one where it is short.
    double parts(const Positions& x, const Positions& motion) const;
    /// The neighbourhood in which each_nearby() and pairs_nearby() search.
    Neighbourhood surroundings(const Positions& x, const Positions& motion) const;
    // The candidates of a neighbourhood with x, and with the motion from it:
    const ContactCandidates& candidates(const Positions& x) const;
    const ContactCandidates& candidates(const Positions& x, const Positions& motion) const;

    ContactSurface of;
    Threads threads;
    SecondSpring spring_of_pairs;
    // Caches: no result depends on them.
    mutable CachedTrees trees;
    mutable ContactCandidates found;          ///< candidates for many steps to come
    mutable Positions last;                   ///< m, positions of the last call of active_pairs()
    mutable std::vector<ContactPair> active;  ///< active pairs at `last`
};

}  // namespace sherd
