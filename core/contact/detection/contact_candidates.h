// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/contact/detection/solid_trees.h"

namespace sherd {

/// The pairs of a surface's elements that come near touching somewhere in a neighbourhood. To find them costs
/// most of what contact costs. To pick those for a smaller neighbourhood costs little, as most show in
/// passing that they are apart: along a direction in which they were when they were last looked at closely.
class ContactCandidates {
  public:
    /// Times the touching distance is near.
    static constexpr double nearness = 1.15;

    ContactCandidates() = default;
    /// solids: what is kept of them from one call to the next.
    ContactCandidates(const ContactSurface& surface, Neighbourhood neighbourhood, SolidTrees& solids);

    const Neighbourhood& neighbourhood() const { return within; }
    /// Pairs among which are all that come near touching somewhere in `smaller`, which has to be in the
    /// neighbourhood; ascending, vertices with triangles first.
    std::vector<ContactPair> pick(const ContactSurface& surface, const Neighbourhood& smaller);
    /// Looks for pairs anew where triangles have got other vertices, or vertices got or lost twins. A vertex
    /// that is new has the start and the motion of the one it replaced.
    void follow(const ContactSurface& before, const ContactSurface& after, SolidTrees& solids);

  private:
    struct Candidate {
        PairKind kind;
        std::array<Index, 4> vertices;  ///< in the order of PairPositions
        double touching;                ///< m
        Vector3d direction;             ///< from the second element to the first, of length 1
    };

    /// Looks at all pairs with a vertex that has changed.
    void find(const ContactSurface& surface, const std::vector<char>& changed, SolidTrees& solids);
    void find_on_sheets(const ContactSurface& surface, const std::vector<char>& changed);
    void find_on_solids(const ContactSurface& surface, const std::vector<char>& changed, SolidTrees& solids);
    void look_at(const ContactSurface& surface, PairKind kind, const std::array<Index, 4>& vertices);

    Neighbourhood within;
    std::vector<Candidate> candidates;
};

}  // namespace sherd
