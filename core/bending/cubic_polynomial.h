// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "core/energy.h"
#include "core/state_visitor.h"

namespace sherd {

/// An energy of third degree in the positions that no rigid motion changes:
///     E = 1/2 sum s_ab |x_a - x_b|^2 - sum k [e0, e1, e2] + constant,
/// with springs of length zero, whose stiffness s is also negative, and triple products of hinges' edges. The
/// springs are the paper's constant matrix Q: s_ab = -Q_ab.
class CubicPolynomial : public Energy {
  public:
    struct Spring {
        Index first, second;
        double stiffness;  ///< N/m
        double convex;     ///< N/m, of a sum of springs that is positive semidefinite
    };
    struct Triple {
        std::array<Index, 4> vertices;  ///< of a hinge, in the order of HingePositions
        double factor;                  ///< k, N/m^2
    };

    CubicPolynomial() = default;
    /// Springs may be given in any order, and more than once. rest: [3, V] m, for round_off().
    CubicPolynomial(std::span<const Spring> springs, std::vector<Triple> triples, double constant,
                    const Positions& rest);

    double value(const Positions& x) const override;
    double round_off() const override { return error; }
    void add_gradient(const Positions& x, Positions& gradient) const override;
    /// Curvature::convex: that of the convex springs alone.
    void add_hessian(const Positions& x, Curvature curvature, BlockMatrix& hessian) const override;
    void add_pattern(std::vector<std::pair<Index, Index>>& pairs) const override;

    void visit_state(StateVisitor& visit) override {
        auto& [springs, triples, constant, error] = *this;
        visit(springs, triples, constant, error);
    }

  private:
    std::vector<Spring> springs;  ///< each pair once, by ascending first vertex
    std::vector<Triple> triples;
    double constant = 0, error = 0;
};

}  // namespace sherd
