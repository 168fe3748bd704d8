// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <deque>
#include <vector>

#include "core/vector.h"

namespace sherd {

/// Corrections of an approximate inverse Hessian by the last steps of a minimisation: limited memory BFGS
/// (Nocedal 1980; Nocedal, Wright, Numerical Optimization, algorithm 7.4).
class UpdateMemory {
  public:
    explicit UpdateMemory(std::size_t size) : size(size) {}
    void clear() { updates.clear(); }
    /// Adds a step, m, [3, N], and the change of the gradient along the step, N, [3, N] (see Potential).
    /// Steps without positive curvature are ignored.
    void add(Positions step, Positions change) {
        const double product = step.cwiseProduct(change).sum();
        if (!(product > least_cosine * step.norm() * change.norm())) return;
        if (updates.size() == size) updates.pop_front();
        updates.push_back({std::move(step), std::move(change), 1 / product});
    }
    /// Returns the corrected inverse Hessian times a gradient, m, [3, N]. solve(gradient) applies the inverse
    /// Hessian that is to be corrected.
    template <class Solve>
    Positions apply(Positions gradient, const Solve& solve) const {
        std::vector<double> shares(updates.size());
        for (std::size_t i = updates.size(); i-- > 0;) {
            const auto& [step, change, scale] = updates[i];
            shares[i] = scale * step.cwiseProduct(gradient).sum();
            gradient -= shares[i] * change;
        }
        Positions direction = solve(gradient);
        for (std::size_t i = 0; i < updates.size(); ++i) {
            const auto& [step, change, scale] = updates[i];
            direction += (shares[i] - scale * change.cwiseProduct(direction).sum()) * step;
        }
        return direction;
    }

  private:
    static constexpr double least_cosine = 1e-10;
    struct Update {
        Positions step, change;
        double scale;
    };

    std::size_t size;
    std::deque<Update> updates;
};

}  // namespace sherd
