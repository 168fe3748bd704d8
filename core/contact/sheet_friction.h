// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/contact/friction.h"
#include "core/contact/sheet_contact.h"

namespace sherd {

/// How two elements that touch slide on each other.
struct SlidingPair {
    std::array<Index, 4> vertices;
    Eigen::Matrix<double, 3, 12> slip;  ///< of the vertices' displacements in the step
    Matrix3d tangent;                   ///< projection to the plane of sliding
    Friction friction;
};

/// The sliding of a pair at x, with the normal force and the closest points it has there. The two points are
/// a thickness apart; of their motion against each other counts what is not the pair's rotation, as the edges
/// of its elements show it, so that what turns as a whole does not slide, and friction has no net torque.
SlidingPair sliding_pair(const ContactPair& pair, const PairPositions& x, double coefficient, double step);

/// Coulomb friction between sheets, and of sheets on the surfaces of solids with their own coefficients, in
/// one step, for the pairs that touch at its beginning and with their normal forces there.
class SheetFriction : public Energy {
  public:
    /// sheet.position are the positions at the beginning of the step. coefficient: of sheets on sheets;
    /// step: s. What contact says of solids is asked now and never again.
    SheetFriction(const Sheet& sheet, const SheetContact& contact, double coefficient, double step);
    double value(const Positions& x) const override;
    void add_gradient(const Positions& x, Positions& gradient) const override;
    void add_hessian(const Positions& x, Curvature curvature, BlockMatrix& hessian) const override;
    Task task() const override { return Task::contact; }
    void add_pattern(std::vector<std::pair<Index, Index>>&) const override {}
    void add_contacts(const Positions& x, bool ahead,
                      std::vector<std::pair<Index, Index>>& pairs) const override;

  private:
    Vector3d slip(const SlidingPair& pair, const Positions& x) const;  ///< m

    Index first = 0;                 ///< vertex of the sheets, in the numbers of the pairs
    Positions start;                 ///< [3, S + V] m, all vertices at the beginning of the step
    Positions solids;                ///< [3, S] m, displacements
    std::vector<SlidingPair> pairs;  ///< in the numbers of ContactSurface
};

}  // namespace sherd
