// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/contact/friction/stick_memory.h"
#include "core/contact/sheets/sheet_contact.h"
#include "core/state_visitor.h"

namespace sherd {

/// Key of two elements in contact, for StickMemory; vertices are numbered as in SheetContact::surface().
struct PairKey {
    PairKind kind = PairKind::vertex_triangle;
    std::array<Index, 4> vertices{};

    auto operator<=>(const PairKey&) const = default;
};

/// The friction of two elements in contact, in one step.
struct SlidingPair {
    PairKind kind;
    std::array<Index, 4> vertices;
    Eigen::Matrix<double, 3, 12> slip;  ///< maps displacements of the vertices in the step to the slip
    Matrix3d tangent;                   ///< projection to the plane of sliding
    Friction friction;

    // moved: displacements of the four vertices in the step, [3, 4] m.
    double value(const PairPositions& moved) const { return friction.value(slip * moved.reshaped()); }
    PairPositions gradient(const PairPositions& moved) const;
    PairHessian hessian(const PairPositions& moved) const;
    PairKey key() const { return {kind, vertices}; }
    /// Elastic slip for the next step: see Friction::elastic_slip_after().
    Vector3d elastic_slip_after(const PairPositions& moved) const {
        return friction.elastic_slip_after(slip * moved.reshaped());
    }
};

/// The friction of a pair, with its normal force and its closest points at x. Since the two points are about
/// a thickness apart, their relative motion counts as slip only after the pair's rotation, estimated from the
/// edges of its elements, is subtracted: a pair that rotates as a whole does not slide, and friction exerts
/// no net torque. coefficient: Coulomb coefficient; length: s, of the step; elastic_slip: in multiples of
/// Friction::smoothing, from StickMemory.
SlidingPair sliding_pair(const ContactPair& pair, const PairPositions& x, double coefficient, double length,
                         const Vector3d& elastic_slip = Vector3d::Zero());

/// Sliding pairs, as elements on the displacements of their vertices in the step. S is the number of the
/// colliders' vertices, V the number of the shell's.
struct SlidingPairs {
    std::vector<SlidingPair> pairs;  ///< their vertices are numbered as in SheetContact::surface()
    Index first = 0;                 ///< number of the first vertex of sheets, S
    Positions start;                 ///< [3, S + V] m, positions of all vertices at the beginning of the step
    Positions colliders;             ///< [3, S] m, displacements of the colliders' vertices in the step

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

/// Coulomb friction in one step: between sheets, and of sheets on the surfaces of colliders with the
/// colliders' coefficients. Friction acts on the pairs that are active at the beginning of the step, with
/// their normal forces at that time.
class SheetFriction : public ElementEnergy<SlidingPairs> {
  public:
    /// coefficient: Coulomb coefficient between sheets. `shell` and `contact` must outlive this object; in
    /// each step, contact.begin() must be called before begin().
    SheetFriction(const Shell& shell, const SheetContact& contact, double coefficient)
        : ElementEnergy({}), shell(shell), contact(contact), coefficient(coefficient) {}
    void begin(const StepContext& step) override;
    /// Stores the elastic slip for the next step, when the step ends at x.
    void finish(const Positions& x);
    Task task() const override { return Task::contact; }
    // Pairs may change with every step, so no pair is part of the fixed pattern.
    void add_pattern(std::vector<std::pair<Index, Index>>&) const override {}
    void add_contacts(const Positions& x, bool ahead,
                      std::vector<std::pair<Index, Index>>& pairs) const override;
    /// Energy dissipated by friction in the step that ends at x, J.
    double friction_loss(const Positions& x) const;
    /// See SheetContact::add_reactions().
    void add_reactions(const Positions& x, std::span<Reaction> of_obstacles) const {
        contact.add_reactions(elements, x, of_obstacles);
    }
    /// Work, J, that deforming obstacles do against friction in the step that ends at x.
    double work_of_deforming(const Positions& x) const { return contact.work_of_deforming(elements, x); }
    void visit_state(StateVisitor& visit) override {
        static_assert(has_only<SheetFriction, ElementEnergy<SlidingPairs>, decltype(shell), decltype(contact),
                               decltype(coefficient), decltype(elastic_slip)>());
        ElementEnergy::visit_state(visit);
        visit(elastic_slip);
    }

  private:
    const Shell& shell;
    const SheetContact& contact;
    double coefficient;
    StickMemory<PairKey> elastic_slip;  ///< elastic slip at the end of the last finished step
};

}  // namespace sherd
