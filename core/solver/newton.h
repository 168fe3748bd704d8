// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "core/solver/minimiser.h"
#include "core/solver/newton_system.h"
#include "core/state_visitor.h"

namespace sherd {

/// Newton's method with a backtracking line search.
class Newton : public Minimiser {
  public:
    /// tolerance: m; the method has converged when the largest coordinate of a correction is below it.
    explicit Newton(double tolerance = 1e-9) : tolerance(tolerance), system(cholesky_solver()) {}
    void topology_changed(const ShellChange& change, const Potential& potential, const Positions& x) override;
    MinimiserResult minimise(Potential& potential, int max_iterations, Positions& x) override;
    void set_tolerance(double value) override { tolerance = value; }
    void visit_state(StateVisitor& visit) override {
        auto& [tolerance, system] = *this;
        visit(system);
    }

  private:
    double tolerance;
    NewtonSystem system;
};

}  // namespace sherd
