// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <deque>
#include <utility>

#include "core/solver/hessian_patch.h"
#include "core/solver/newton_system.h"
#include "core/state_visitor.h"

namespace sherd {

/// Factor of an earlier Hessian as an approximate inverse of the present one. The rows of each vertex are
/// rotated as the sheet around it has rotated since; vertices inserted since share the rows of their parent.
/// The columns of bodies (see Potential) count as vertices that do not rotate.
/// Where contacts have begun or ended and around new cracks, a patch with the present Hessian corrects the
/// solution, before and after (symmetric multiplicative Schwarz: Smith, Bjorstad, Gropp, Domain
/// Decomposition, 1996). Where a contact alternates from one iteration to the next, the patch has half of it.
class LaggedSystem {
  public:
    explicit LaggedSystem(Threads of = Threads())
        : threads(std::move(of)), system(single_precision_solver(threads)) {}
    /// Factors the Hessian at x.
    void factorize(const Potential& potential, const Positions& x);
    /// Whether there is a factor for the shell as it is.
    bool has_factor() const { return !sources.empty(); }
    /// Iterations that take as long as a factorization. hessian, forces: the time of a Hessian, and of an
    /// iteration without the solution, in entries of a factor that take as long.
    double iterations_per_factorization(double hessian, double forces) const {
        return system.iterations_per_factorization(hessian, forces);
    }
    /// Finds the rotations of the vertices at x, and drops the patch.
    void turn(const Potential& potential, const Positions& x);
    enum class Fit { fits, patched, needs_factor };
    /// Compares the system with the contacts at x, and builds a patch where it does not fit them.
    Fit fit(const Potential& potential, const Positions& x);
    /// Solves with the factor. right_side: N, [3, N].
    Positions solve(const Potential& potential, const Positions& right_side);
    /// Must be called when the shell has changed. Inserted vertices share their parent's rows; if triangles
    /// have changed, the factor is dropped. body_columns: see Potential.
    void topology_changed(const ShellChange& change, Index body_columns);
    void visit_state(StateVisitor& visit);

  private:
    /// Contact stiffness in a system of a search.
    struct Fitted {
        std::vector<Matrix3d> stiffness;  ///< [V] N/m, diagonal blocks
        Positions x;                      ///< m, [3, V], positions of that system; empty: not of this search
    };

    Positions solve_lagged(const Potential& potential, const Positions& right_side);
    /// Whether the contact stiffness of a vertex differs from the known one by more than a small share of the
    /// vertex's block in the factor and the share `part` of the known one.
    bool differ(std::size_t vertex, const Matrix3d& stiffness, const Matrix3d& known, double part) const;
    /// Whether the contact stiffness of each vertex is like that in one of the last `count` systems of this
    /// search.
    bool is_unchanged(const std::vector<Matrix3d>& stiffness, std::size_t count) const;
    /// Flags, [V], of the vertices where the contact stiffness, or the other one in an alternating patch,
    /// differs from the factor, and of those around them.
    std::vector<char> changed(const Shell& shell, const std::vector<Matrix3d>& stiffness) const;
    /// Drops the patch and all known systems but that of the factor. x: its positions; empty: of an earlier
    /// search.
    void reset(Positions x = {});

    Threads threads;
    NewtonSystem system;
    bool outdated = true;             ///< whether the matrix has the pattern of another shell
    std::vector<Index> sources;       ///< [V] vertex of the factor for each vertex; empty: no factor
    std::vector<char> cracked;        ///< [V] whether a crack has changed the sheet there since
    std::vector<Matrix3d> frames;     ///< [F] inverse frames at the factorization
    std::vector<Matrix3d> rotations;  ///< [V] rotations since then; empty: none
    VectorXd of_piece;                ///< [V] N/m, see inertia_of_pieces()
    std::vector<Matrix3d> in_factor;  ///< [V] N/m, contact stiffness in the factor
    std::deque<Fitted> fitted;        ///< the last systems of a search, the present one last
    bool fits_two = false;            ///< whether the patch has half of the previous system's contacts, too
    VertexGraph graph;                ///< graph of the shell as it is; empty: not built yet
    HessianPatch patch;
};

}  // namespace sherd
