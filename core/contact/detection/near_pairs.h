// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <set>

#include "core/contact/detection/contact_candidates.h"
#include "core/state_visitor.h"

namespace sherd {

/// Finds the active pairs of a surface at a sequence of positions. Results of a search are reused as long as
/// they are valid; no answer depends on earlier calls. Positions are arrays [3, surface().vertices()] m of
/// all vertices of the surface; motions are displacements of the vertices.
class NearPairs {
  public:
    explicit NearPairs(ContactSurface surface, Threads threads = Threads())
        : of(std::move(surface)), threads(std::move(threads)), found(this->threads) {}
    /// Replaces the surface by one whose sheets, or their exempt vertices, have changed by `change`.
    void surface_changed(const ShellChange& change, ContactSurface surface);
    const ContactSurface& surface() const { return of; }

    /// Returns the active pairs at x, ascending, vertex-triangle pairs first. The list is valid until the
    /// next call.
    const std::vector<ContactPair>& active_pairs(const Positions& x) const;
    /// Returns a fraction, 0 to 1, of a straight motion from x up to which every pair stays above its minimum
    /// distance. The tested motion ends where a vertex has moved by 128 mean widths of triangles (without
    /// colliders, relative to the mean of all vertices).
    double safe_fraction(const Positions& x, const Positions& motion) const {
        return free_fraction(x, motion, Gap::minimum);
    }
    /// Whether middle surfaces pass through each other somewhere in a straight motion from x, whatever their
    /// thickness; also true if a vertex moves beyond the limit of safe_fraction().
    bool passes(const Positions& x, const Positions& motion) const {
        return free_fraction(x, motion, Gap::nothing) < 1;
    }
    /// Whether passes() is true for one of the `parts` straight parts of a path. at(share) returns the
    /// positions after a share, 0 to 1, of the path.
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
    /// Sets the second spring of all pairs that are springs, also of pairs that are found later.
    void set_second_spring(SecondSpring of_springs);
    SecondSpring second_spring() const { return spring_of_pairs; }
    /// The smallest ratio of distance to activation distance among the active pairs at x; 1 if no pair is
    /// active.
    double least_share(const Positions& x) const;
    /// Whether all active pairs at x could be barriers: whether their distances exceed minimum_of_barrier()
    /// by at least 2 % of the barriers' ranges.
    bool allow_barriers(const Positions& x) const;
    /// Returns a superset of the pairs that are active at x or whose distance there is less than a tenth of
    /// the thinnest sheet's thickness. The function makes a search of its own, whose result is not reused.
    std::vector<ContactPair> pairs_nearby(const Positions& x) const;
    /// Calls visit_pair(pair) for a superset of the pairs that pairs_nearby() finds anywhere between x and x
    /// + motion, several times for some pairs; makes no calls if the motion exceeds the limit of
    /// safe_fraction().
    void each_nearby(const Positions& x, const Positions& motion,
                     const std::function<void(const ContactPair&)>& visit_pair) const;
    /// Returns the pairs that may be active somewhere in a straight motion from x.
    std::vector<ContactPair> pairs_within_reach(const Positions& x, const Positions& motion) const;
    /// Appends the pairs of shell vertices, numbered as in the shell, that have a block in a Hessian: with
    /// `ahead` false, due to contact pairs that are active at x; with `ahead` true, due to all contact pairs
    /// that are near at x (ContactCandidates::nearness).
    void add_contacts(const Positions& x, bool ahead, std::vector<std::pair<Index, Index>>& pairs) const;

    /// For all active pairs at x with a collider, adds their vertices of sheets, numbered as in the shell, to
    /// `vertices`, and the surfaces of the colliders to `touched`.
    void add_touched(const Positions& x, std::set<Index>& vertices,
                     std::set<const ColliderSurface*>& touched) const;

    /// Visits the state: no threads, and no trees, which follow from the positions.
    void visit_state(StateVisitor& visit) {
        auto& [of, threads, spring_of_pairs, trees, found, last, active] = *this;
        visit(of, spring_of_pairs, found, last, active);
    }

  private:
    /// Finds the candidates of a neighbourhood that contains the motion from x and, if steps are small, many
    /// more steps like it.
    void find(const Positions& x, const Positions& motion) const;
    /// The least distance of pairs in a motion that counts as free: their minimum distance, or zero.
    enum class Gap { minimum, nothing };
    double free_fraction(const Positions& x, const Positions& motion, Gap gap) const;
    double free_fraction_of_part(const Positions& x, const Positions& motion, Gap gap) const;
    /// Number of parts in which a motion is tested; 1 if the motion is short. At most 64 of the parts are
    /// tested.
    double parts(const Positions& x, const Positions& motion) const;
    /// The neighbourhood in which each_nearby() and pairs_nearby() search.
    Neighbourhood surroundings(const Positions& x, const Positions& motion) const;
    // The following functions return the candidates of a neighbourhood that contains x, and also x + motion
    // in the second case, and search for new candidates where needed:
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
