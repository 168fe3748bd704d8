// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/contact/colliders/contact_solids.h"
#include "core/contact/detection/near_pairs.h"
#include "core/element_energy.h"

namespace sherd {

/// Contact of sheets and fragments with each other and with themselves, and with the surfaces of solids: the
/// barriers of all pairs of a vertex and a triangle, and of two edges, that are nearer than half the sum of
/// their thicknesses (Li et al. 2020, with the thickness of Li, Kaufman, Jiang 2021). Infinite where a pair
/// is nearer than its minimum, which no motion up to safe_fraction() leads to.
class SheetContact : public Energy {
  public:
    /// The sheet must outlive it. sheets_meet: whether elements of sheets meet each other.
    explicit SheetContact(const Sheet& sheet, std::vector<Obstacle> obstacles = {}, bool sheets_meet = true);
    /// Places the solids; energies are those at the end of the step.
    void begin(const StepContext& step) override;
    void topology_changed(const ShellChange& change, const StepContext& step) override;

    double value(const Positions& x) const override;
    void add_gradient(const Positions& x, Positions& gradient) const override;
    void add_hessian(const Positions& x, Curvature curvature, BlockMatrix& hessian) const override;
    Task task() const override { return Task::contact; }
    void add_contacts(const Positions& x, bool ahead,
                      std::vector<std::pair<Index, Index>>& pairs) const override;
    double safe_fraction(const Positions& x, const Positions& motion) const override;

    /// As safe_fraction(), from where the sheet (x) and the solids are at the beginning of the step, and with
    /// the motion of the solids.
    double safe_fraction_of_step(const Positions& x, const Positions& motion) const;
    /// For each vertex that a solid that moves is near to, or will be, the solid's displacement in the step;
    /// zero for the others. x: at the beginning of the step. [3, V] m.
    Positions pushed_along(const Positions& x) const;

    const ContactSurface& surface() const { return near.surface(); }
    /// x [3, V] with the solids before it, at the end of the step and at its beginning; what
    /// surface().vertices() numbers.
    const Positions& at_end(const Positions& x) const { return with(end, x); }
    Positions at_start(const Positions& x) const { return with(start, x); }
    /// The pairs that push at x, vertices with triangles first, ascending. Valid until the next call.
    const std::vector<ContactPair>& touching(const Positions& x) const { return near.touching(at_end(x)); }
    /// The same with the solids where they are at the beginning of the step.
    const std::vector<ContactPair>& touching_at_start(const Positions& x) const {
        return near.touching(with(start, x));
    }
    /// Adds the vertices that touch solids at x, and these.
    void add_touched(const Positions& x, std::set<Index>& vertices,
                     std::set<const SolidSurface*>& touched) const {
        near.add_touched(at_end(x), vertices, touched);
    }
    /// Throws std::runtime_error, with the vertices of the first pair, if any is nearer than its minimum at
    /// the beginning of the step, where the sheet is at x.
    void require_apart(const Positions& x) const;

  private:
    /// The pairs that push, as elements.
    struct Pairs {
        const std::vector<ContactPair>& pairs;
        const Positions& all;  ///< m, of solids and sheets
        Index first;           ///< vertex of sheets

        std::size_t size() const { return pairs.size(); }
        std::array<Index, 4> vertices(std::size_t i) const { return numbered_from(pairs[i].vertices, first); }
        PairPositions gather(std::size_t i, const Positions&) const {
            return columns(all, pairs[i].vertices);
        }
        double value(std::size_t i, const PairPositions& x) const { return sherd::value(pairs[i], x); }
        PairPositions gradient(std::size_t i, const PairPositions& x) const {
            return sherd::gradient(pairs[i], x);
        }
        PairHessian hessian(std::size_t i, const PairPositions& x, Curvature curvature) const {
            return sherd::hessian(pairs[i], x, curvature == Curvature::convex);
        }
    };

    Pairs pairs_at(const Positions& all) const;
    /// Both in one row; kept until the next call.
    const Positions& with(const Positions& solid, const Positions& x) const;

    const Sheet& sheet;
    std::vector<Obstacle> obstacles;
    std::vector<ContactSolid> solids;
    NearPairs near;
    Positions start, end;     ///< [3, S] m, of the solids' vertices, those of all solids in one row
    mutable Positions whole;  ///< kept to save memory
};

}  // namespace sherd
