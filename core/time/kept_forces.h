// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/state_visitor.h"
#include "core/vector.h"

namespace sherd {

/// What held an edge together when it failed, as forces on vertices.
struct KeptForces {
    std::vector<Index> vertices;  ///< ascending
    Positions forces;             ///< N, on each of them

    KeptForces() = default;
    /// of_all: [3, V] N. Those below 1e-10 of the largest are round-off, and left out.
    explicit KeptForces(const Positions& of_all);
    /// J, against them when vertices move by `moved`, [3, V] m.
    double against(const Positions& moved) const {
        return -forces.cwiseProduct(moved(Eigen::all, vertices)).sum();
    }
    /// The same from where these vertices were to where all are, x: [3, V] m.
    double against_from(const Positions& these, const Positions& x) const {
        return -forces.cwiseProduct(of_these(x) - these).sum();
    }
    /// Adds `share` of them to sums, [3, V].
    void add(double share, Positions& sum) const;
    /// The columns of these vertices.
    Positions of_these(const Positions& of_all) const { return of_all(Eigen::all, vertices); }
    void visit_state(StateVisitor& visit) {
        auto& [vertices, forces] = *this;
        visit(vertices, forces);
    }
};

}  // namespace sherd
