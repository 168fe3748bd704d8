// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/energy.h"
#include "core/shell/shell.h"

namespace sherd {

/// For each vertex an upper bound on the squared frequencies of vibrations in which this vertex moves most:
/// the sum of the norms of the blocks in the vertex's row of the Hessian, over its mass. The largest entry
/// bounds all frequencies of the shell (Gershgorin).
class FrequencyBounds {
  public:
    /// Computes the bounds with the shell at x, [3, V] m. energies: all that store elastic energy.
    void find(std::span<Energy* const> energies, const Shell& shell, const Positions& x);
    /// Computes the bounds again only near vertices whose faces, hinges or mass have changed since the last
    /// call of one of these functions.
    void follow(std::span<Energy* const> energies, const Shell& shell, const Positions& x);

    /// [V] 1/s^2; zero for fixed vertices.
    const VectorXd& squares() const { return square; }
    /// The triangle with the largest sum of its vertices' bounds, in the shell of the last call of find() or
    /// follow(); none before the first one.
    std::optional<Index> fastest_triangle() const { return fastest; }

    void visit_state(StateVisitor& visit) {
        auto& [square, fastest, surroundings] = *this;
        visit(square, fastest, surroundings);
    }

  private:
    void find_near(std::span<Energy* const> energies, const Shell& shell, const Positions& x,
                   std::vector<char> near);
    void find_fastest(const Shell& shell);

    VectorXd square;
    std::optional<Index> fastest;
    std::vector<std::uint64_t> surroundings;  ///< [V] hash of each vertex's faces, hinges and mass
};

}  // namespace sherd
