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

/// The positions within a margin, at each vertex, of some moment of a straight motion. Without colliders, a
/// common translation of all vertices is disregarded since it changes no distance. The set is convex: if it
/// contains the ends of a straight motion, it contains all of it.
class Neighbourhood {
  public:
    Neighbourhood() = default;
    /// x, motion: [3, V] m, the first `colliders` vertices belonging to colliders; margin: m.
    Neighbourhood(const Positions& x, const Positions& motion, double margin, Index colliders = 0);

    bool contains(const Positions& x) const { return contains(x, 0); }
    bool contains(const Neighbourhood& other) const;

    void visit_state(StateVisitor& visit) {
        auto& [start, motion, margin, round_off, colliders, colliders_rest] = *this;
        visit(start, motion, margin, round_off, colliders, colliders_rest);
    }

    Positions start;       ///< [3, V] m
    Positions motion;      ///< m; without colliders, the common translation is subtracted
    double margin = 0;     ///< m
    double round_off = 0;  ///< m, bound on round-off, far above the actual error of any distance

  private:
    bool contains(const Positions& x, double spare) const;

    Index colliders = 0;
    bool colliders_rest = true;  ///< whether the colliders are at rest, so that their vertices need no check
};

/// Trees of bounding boxes around the elements of colliders, kept as long as a collider rests. Many colliders
/// have far more elements than the sheets, and do not move.
class ColliderTrees {
  public:
    /// The trees of one collider, in which element 0 is the first of that collider.
    struct Trees {
        BoxTree points, edges, triangles;
    };
    /// The trees around the paths of a collider's vertices on the motion of `within`, without any margin;
    /// null where the box around all paths does not meet `reach`. Trees are valid until the next call.
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

/// Trees, and divisions of trees, that a search for pairs leaves to the next one. No result depends on them.
struct CachedTrees {
    ColliderTrees colliders;
    BoxTree::Division vertices, triangles, edges;  ///< divisions of the sheets' elements
};

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
