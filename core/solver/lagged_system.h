// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <deque>
#include <utility>

#include "core/solver/hessian_patch.h"
#include "core/solver/newton_system.h"
#include "core/state_visitor.h"

namespace sherd {

/// Factor of an earlier Hessian as an approximate inverse of the present one. The rows of each vertex are
/// rotated as the sheet around it has rotated since the factorization; vertices inserted since then share the
/// rows of their parent. The columns of bodies (see Potential) count as vertices that do not rotate. Where
/// contacts have begun or ended and around new cracks, a patch solves with the present Hessian before and
/// after the solution with the factor (symmetric multiplicative Schwarz: Smith, Bjorstad, Gropp, Domain
/// Decomposition, 1996). If contacts alternate from one iteration to the next, the patch has the mean of the
/// contact stiffnesses of two iterations.
class LaggedSystem {
  public:
    explicit LaggedSystem(Threads of = Threads())
        : threads(std::move(of)), system(single_precision_solver(threads)) {}
    /// Factors the Hessian at x.
    void factorize(const Potential& potential, const Positions& x);
    /// Whether there is a factor for the shell as it is.
    bool has_factor() const { return !sources.empty(); }
    /// See NewtonSystem::iterations_per_factorization().
    double iterations_per_factorization(double hessian, double forces) const {
        return system.iterations_per_factorization(hessian, forces);
    }
    /// Finds the rotations of the vertices from the factorization to x, and drops the patch.
    void turn(const Potential& potential, const Positions& x);
    enum class Fit { fits, patched, needs_factor };
    /// Compares the system with the contacts at x, and builds a patch where the system does not fit the
    /// contacts.
    Fit fit(const Potential& potential, const Positions& x);
    /// Solves with the factor and the patch. right_side: forces, N, [3, N] as in Potential.
    Positions solve(const Potential& potential, const Positions& right_side);
    /// Must be called when the shell has changed. Inserted vertices share their parent's rows; if triangles
    /// have changed, the factor is dropped. body_columns: see Potential.
    void topology_changed(const ShellChange& change, Index body_columns);
    void visit_state(StateVisitor& visit);

  private:
    /// Contact stiffness in a system (factor and patch) that a search has used.
    struct Fitted {
        std::vector<Matrix3d> stiffness;  ///< [V] N/m, diagonal blocks
        Positions x;                      ///< m, [3, N], positions of that system; empty: not of this search
    };

    Positions solve_lagged(const Potential& potential, const Positions& right_side);
    /// Whether the contact stiffness of a vertex differs from `known` by more than the sum of a small share
    /// of the vertex's block in the factor and the share `part` of `known`; the bound is lower in loose
    /// pieces.
    bool differ(std::size_t vertex, const Matrix3d& stiffness, const Matrix3d& known, double part) const;
    /// Whether the contact stiffness of each vertex is close to its value in one of the last `count` systems
    /// of this search.
    bool is_unchanged(const std::vector<Matrix3d>& stiffness, std::size_t count) const;
    /// Flags, [V], of cracked vertices, of vertices whose contact stiffness (if fits_two, also in the
    /// previous system) differs from its value in the factor, and of the vertices around them.
    std::vector<char> changed(const Shell& shell, const std::vector<Matrix3d>& stiffness) const;
    /// Drops the patch and all entries of `fitted` but the factor's. x: positions of the factor; empty if it
    /// was made in an earlier search.
    void reset(Positions x = {});

    Threads threads;
    NewtonSystem system;
    bool outdated = true;        ///< whether the pattern must be rebuilt since the shell has changed
    std::vector<Index> sources;  ///< [V] for each vertex, its vertex in the factor; empty: no factor
    std::vector<char> cracked;   ///< [V] whether a crack has changed the sheet there since the factorization
    std::vector<Matrix3d> frames;     ///< [F] inverse frames at the factorization
    std::vector<Matrix3d> rotations;  ///< [V] rotations since the factorization; empty: no rotations
    VectorXd of_piece;                ///< [V] N/m, see inertia_of_pieces()
    std::vector<Matrix3d> in_factor;  ///< [V] N/m, contact stiffness in the factor
    std::deque<Fitted> fitted;        ///< the last systems of a search, the present one last
    bool fits_two = false;  ///< whether the patch has the mean contact stiffness of the last two systems
    VertexGraph graph;      ///< graph of the shell as it is; empty: not built yet
    HessianPatch patch;
};

}  // namespace sherd
