// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/state_visitor.h"
#include "core/vector.h"

namespace sherd {

/// Forces on vertices that held an edge together when it failed.
struct KeptForces {
    std::vector<Index> vertices;  ///< ascending
    Positions forces;             ///< N, on each of the vertices

    KeptForces() = default;
    /// of_all: [3, V] N. Forces below 1e-10 of the largest are round-off, and left out.
    explicit KeptForces(const Positions& of_all);
    /// Work against the forces, J, when vertices move by `moved`, [3, V] m.
    double against(const Positions& moved) const {
        return -forces.cwiseProduct(moved(Eigen::all, vertices)).sum();
    }
    /// Work against the forces, J, when their vertices move from `these` to their places in x, [3, V] m.
    double against_from(const Positions& these, const Positions& x) const {
        return -forces.cwiseProduct(of_these(x) - these).sum();
    }
    /// Adds `share` times the forces to sums, [3, V] N.
    void add(double share, Positions& sum) const;
    /// Columns that belong to `vertices`.
    Positions of_these(const Positions& of_all) const { return of_all(Eigen::all, vertices); }
    void visit_state(StateVisitor& visit) {
        auto& [vertices, forces] = *this;
        visit(vertices, forces);
    }
};

}  // namespace sherd
