// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/contact/friction/friction.h"
#include "core/contact/sheets/sheet_contact.h"

namespace sherd {

/// How two elements that touch slide on each other.
struct SlidingPair {
    std::array<Index, 4> vertices;
    Eigen::Matrix<double, 3, 12> slip;  ///< of the vertices' displacements in the step
    Matrix3d tangent;                   ///< projection to the plane of sliding
    Friction friction;

    // Of the vertices' displacements, [3, 4] m.
    double value(const PairPositions& moved) const { return friction.value(slip * moved.reshaped()); }
    PairPositions gradient(const PairPositions& moved) const;
    PairHessian hessian(const PairPositions& moved) const;
};

/// The sliding of a pair at x, with the normal force and the closest points it has there. The two points are
/// a thickness apart; of their motion against each other counts what is not the pair's rotation, as the edges
/// of its elements show it, so that what turns as a whole does not slide, and friction has no net torque.
/// lag: s, of the step (StepContext).
SlidingPair sliding_pair(const ContactPair& pair, const PairPositions& x, double coefficient, double lag);

/// Pairs that slide, as elements on the displacements of their vertices since the step's origin.
struct SlidingPairs {
    std::vector<SlidingPair> pairs;  ///< in the numbers of SheetContact::surface()
    Index first = 0;                 ///< vertex of sheets
    Positions origin;                ///< [3, S + V] m
    Positions solids;                ///< [3, S] m, displacements

    std::size_t size() const { return pairs.size(); }
    std::array<Index, 4> vertices(std::size_t i) const { return numbered_from(pairs[i].vertices, first); }
    PairPositions gather(std::size_t i, const Positions& x) const;
    double value(std::size_t i, const PairPositions& moved) const { return pairs[i].value(moved); }
    PairPositions gradient(std::size_t i, const PairPositions& moved) const {
        return pairs[i].gradient(moved);
    }
    PairHessian hessian(std::size_t i, const PairPositions& moved, Curvature) const {
        return pairs[i].hessian(moved);
    }
};

/// Coulomb friction between sheets, and of sheets on the surfaces of solids with their own coefficients, in
/// one step, for the pairs that touch at its beginning and with their normal forces there.
class SheetFriction : public ElementEnergy<SlidingPairs> {
  public:
    /// coefficient: of sheets on sheets. Sheet and contact must outlive it; contact's step begins before.
    SheetFriction(const Sheet& sheet, const SheetContact& contact, double coefficient)
        : ElementEnergy({}), sheet(sheet), contact(contact), coefficient(coefficient) {}
    void begin(const StepContext& step) override;
    Task task() const override { return Task::contact; }
    // Its pairs may change with every step.
    void add_pattern(std::vector<std::pair<Index, Index>>&) const override {}
    void add_contacts(const Positions& x, bool ahead,
                      std::vector<std::pair<Index, Index>>& pairs) const override;

  private:
    const Sheet& sheet;
    const SheetContact& contact;
    double coefficient;
};

}  // namespace sherd
