// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/contact/contact_candidates.h"
#include "core/energy.h"

namespace sherd {

/// Contact of sheets and fragments with each other and with themselves: the barriers of all pairs of a vertex
/// and a triangle, and of two edges, that are nearer than half the sum of their thicknesses (Li et al. 2020,
/// with the thickness of Li, Kaufman, Jiang 2021). Infinite where a pair is nearer than its minimum, which no
/// motion up to safe_fraction() leads to.
class SheetContact : public Energy {
  public:
    /// The sheet must outlive it.
    explicit SheetContact(const Sheet& sheet) : sheet(sheet), surface(sheet) {}
    /// To be called when vertices were added, or triangles or twins changed.
    void surface_changed();

    double value(const Positions& x) const override;
    void add_gradient(const Positions& x, Positions& gradient) const override;
    void add_hessian(const Positions& x, Curvature curvature, BlockMatrix& hessian) const override;
    Task task() const override { return Task::contact; }
    void add_pattern(std::vector<std::pair<Index, Index>>&) const override {}
    void add_contacts(const Positions& x, bool ahead,
                      std::vector<std::pair<Index, Index>>& pairs) const override;
    double safe_fraction(const Positions& x, const Positions& motion) const override;

    /// The pairs that push at x, vertices with triangles first, ascending. Valid until the next call.
    const std::vector<ContactPair>& touching(const Positions& x) const;
    /// Throws std::runtime_error, with the vertices of the first pair, if any is nearer than its minimum at
    /// x.
    void require_apart(const Positions& x) const;

  private:
    /// Pairs among which are all that touch between x and x + motion.
    const std::vector<ContactPair>& candidates(const Positions& x, const Positions& motion) const;

    const Sheet& sheet;
    ContactSurface surface;
    // Kept to save time; no result depends on them.
    mutable ContactCandidates found;          ///< for some time to come
    mutable Neighbourhood near;               ///< where the step is about
    mutable std::vector<ContactPair> pairs;   ///< that may touch there
    mutable Positions last;                   ///< where the touching pairs were last asked for, m
    mutable std::vector<ContactPair> active;  ///< the answer
};

}  // namespace sherd
