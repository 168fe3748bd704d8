// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "core/contact/detection/box_tree.h"
#include "core/contact/detection/contact_surface.h"
#include "core/contact/detection/pair_blocks.h"
#include "core/state_visitor.h"
#include "core/vector.h"

namespace sherd {

/// A set of positions of all vertices: positions at which, for some one moment of a straight motion, every
/// vertex is within a margin of its place at this moment. Without colliders, a common translation of all
/// vertices is disregarded since it changes no distance. The set is convex: if it contains the ends of a
/// straight motion, it contains all of the motion.
class Neighbourhood {
  public:
    Neighbourhood() = default;
    /// x: positions at the beginning of the motion, motion: displacements, both [3, V] m; the first
    /// `colliders` vertices belong to colliders. margin: m.
    Neighbourhood(const Positions& x, const Positions& motion, double margin, Index colliders = 0);

    bool contains(const Positions& x) const { return contains(x, 0); }
    bool contains(const Neighbourhood& other) const;

    void visit_state(StateVisitor& visit) {
        auto& [start, motion, margin, round_off, colliders, colliders_rest] = *this;
        visit(start, motion, margin, round_off, colliders, colliders_rest);
    }

    Positions start;       ///< [3, V] m, positions at the beginning of the motion
    Positions motion;      ///< [3, V] m; without colliders, less the mean displacement
    double margin = 0;     ///< m
    double round_off = 0;  ///< m, bound on the error of any distance, far above the actual error

  private:
    /// Whether x is in the neighbourhood with its margin reduced by `spare` (m).
    bool contains(const Positions& x, double spare) const;

    Index colliders = 0;
    bool colliders_rest = true;  ///< whether the colliders are at rest, so that their vertices need no check
};

/// Trees of bounding boxes around the elements of colliders. The trees of a collider are reused as long as it
/// rests: many colliders have far more elements than the sheets, and do not move.
class ColliderTrees {
  public:
    /// The trees of one collider; their element 0 is the first vertex, edge or triangle of that collider.
    struct Trees {
        BoxTree points, edges, triangles;
    };
    /// Returns trees of the boxes, without any margin, around the paths of the elements of collider number
    /// `collider` in the motion of `within`; null if the box around all these paths does not meet `reach`.
    /// The trees are valid until the next call.
    const Trees* within_reach(const Box& reach, std::size_t collider, const ContactSurface& surface,
                              const Neighbourhood& within);

  private:
    struct Divisions {
        BoxTree::Division points, edges, triangles;
    };
    struct Cached {
        Positions from, to;  ///< m, of the collider's vertices at the beginning and the end of the motion
        Trees trees;
        Divisions divisions;
    };
    std::vector<Cached> cached;
};

/// Trees, and divisions of trees, that a search for pairs stores to make the next search faster. No result
/// depends on them.
struct CachedTrees {
    ColliderTrees colliders;
    BoxTree::Division vertices, triangles, edges;  ///< all elements of the sheets
};

/// Candidate pairs: pairs of elements of a surface that come near contact somewhere in a neighbourhood.
/// Finding the candidates is most of the cost of contact. Finding the active pairs among the candidates is
/// cheap, since most candidates are farther apart than their vertices have moved.
class ContactCandidates {
  public:
    /// Two elements are near when they are closer than this multiple of the activation distance.
    static constexpr double nearness = 1.15;

    /// Makes an object without pairs. threads: they share the work of finding candidates and of later
    /// queries.
    explicit ContactCandidates(Threads threads = Threads()) : threads(std::move(threads)) {}
    /// Finds the candidates of a surface in a neighbourhood. cached: trees of the last search on this
    /// surface; they are replaced by the trees of this search, for the next one.
    ContactCandidates(const ContactSurface& surface, Neighbourhood neighbourhood, CachedTrees& cached,
                      Threads threads = Threads());

    const Neighbourhood& neighbourhood() const { return within; }
    /// Returns the pairs that are active at x, a point of the neighbourhood: ascending, vertex-triangle pairs
    /// first.
    std::vector<ContactPair> active(const ContactSurface& surface, const Positions& x) {
        return pairs.find_active(surface, x, within.round_off, threads);
    }
    /// Returns a superset of the pairs that come near contact somewhere in `smaller`, which must lie in the
    /// neighbourhood: ascending, vertex-triangle pairs first.
    std::vector<ContactPair> pick(const ContactSurface& surface, const Neighbourhood& smaller) const;
    /// See PairBlocks::near(), where `as_near` is called `nearness`. x and x + motion must lie in the
    /// neighbourhood.
    template <class Keep>
    std::vector<ContactPair> near(const Positions& x, const Positions& motion, double as_near, double reserve,
                                  const Keep& keep) const {
        return pairs.near(x, motion, as_near, reserve + within.round_off, threads, keep);
    }
    /// Adapts the candidates to a change of the sheets, where `before` and `after` are the surfaces before
    /// and after the change. Pairs are searched again where triangles have other vertices or another place on
    /// the sheet, or where the exemptions of vertices (exempt_pairs(), near_vertices(), is_surface_exempt())
    /// have changed.
    void follow(const ShellChange& change, const ContactSurface& before, const ContactSurface& after,
                CachedTrees& cached);

    void visit_state(StateVisitor& visit) {
        auto& [within, pairs, threads] = *this;
        visit(within, pairs);
    }

  private:
    /// Finds and adds all candidates with a vertex whose flag in `changed` is set.
    void find(const ContactSurface& surface, const std::vector<char>& changed, CachedTrees& cached);
    /// Two elements whose boxes overlap.
    struct ElementPair {
        PairKind kind;
        std::array<Index, 4> vertices;
    };
    /// The following functions call take(pair) with each ElementPair of which a vertex of sheets has its flag
    /// set in `changed`: the first function with pairs of two elements of sheets, the second with pairs of an
    /// element of sheets and an element of a collider.
    template <class Take>
    void meet_on_sheets(const ContactSurface& surface, const std::vector<char>& changed, CachedTrees& cached,
                        const Take& take) const;
    template <class Take>
    void meet_on_colliders(const ContactSurface& surface, const std::vector<char>& changed,
                           ColliderTrees& colliders, const Take& take) const;
    /// Returns the candidate of two elements; none if they are exempt from contact or do not come near
    /// contact.
    std::optional<PairBlocks::Entry> pair_of(const ContactSurface& surface,
                                             const ElementPair& touching) const;

    Neighbourhood within;
    PairBlocks pairs;
    Threads threads;
};

}  // namespace sherd
