// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/contact/detection/collider_trees.h"
#include "core/state_visitor.h"

namespace sherd {

/// The pairs of a surface's elements that come near contact somewhere in a neighbourhood. Finding them is
/// most of the cost of contact. Selecting those for a smaller neighbourhood is cheap: most pairs are still
/// separated along the direction that separated them when they were last examined.
class ContactCandidates {
  public:
    /// Two elements are near when they are closer than this multiple of the activation distance.
    static constexpr double nearness = 1.15;

    ContactCandidates() = default;
    /// colliders: the trees of the colliders, kept from one call to the next.
    ContactCandidates(const ContactSurface& surface, Neighbourhood neighbourhood, ColliderTrees& colliders);

    const Neighbourhood& neighbourhood() const { return within; }
    /// Returns a superset of the pairs that come near contact somewhere in `smaller`, which must lie in the
    /// neighbourhood. They are ascending, vertex-triangle pairs first.
    std::vector<ContactPair> pick(const ContactSurface& surface, const Neighbourhood& smaller);
    /// Searches pairs again where triangles have other vertices or another place on the sheet, or where
    /// vertices gained or lost twins or others that are near since the start.
    void follow(const ShellChange& change, const ContactSurface& before, const ContactSurface& after,
                ColliderTrees& colliders);

    void visit_state(StateVisitor& visit) {
        auto& [within, candidates] = *this;
        visit(within, candidates);
    }

  private:
    struct Candidate {
        PairKind kind;
        std::array<Index, 4> vertices;  ///< in the order of PairPositions
        double activation_distance;     ///< m, activation distance
        Vector3d direction;             ///< unit vector from the second element to the first
    };

    /// Searches all pairs with a vertex that has changed.
    void find(const ContactSurface& surface, const std::vector<char>& changed, ColliderTrees& colliders);
    void find_on_sheets(const ContactSurface& surface, const std::vector<char>& changed);
    void find_on_colliders(const ContactSurface& surface, const std::vector<char>& changed,
                           ColliderTrees& colliders);
    void consider(const ContactSurface& surface, PairKind kind, const std::array<Index, 4>& vertices);

    Neighbourhood within;
    std::vector<Candidate> candidates;
};

}  // namespace sherd
