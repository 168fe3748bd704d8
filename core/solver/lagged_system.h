// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <deque>
#include <utility>

#include "core/solver/hessian_patch.h"
#include "core/solver/newton_system.h"
#include "core/state_visitor.h"

namespace sherd {

/// The factor of the Hessian at an earlier time as an approximate inverse of the Hessian now. Each vertex
/// takes its part of it turned as the sheet around it has turned since; vertices that were born since take
/// that of the vertex that they come from. Where contacts have come or gone and around new cracks, a patch
/// with the Hessian as it is corrects it, before and after (symmetric multiplicative Schwarz: Smith,
/// Bjorstad, Gropp, Domain Decomposition, 1996). Where a contact comes and goes from one iteration to the
/// next, the patch has half of it.
class LaggedSystem {
  public:
    explicit LaggedSystem(Threads of = Threads())
        : threads(std::move(of)), system(single_precision_solver(threads)) {}
    /// Factors the Hessian at x.
    void factorize(const Potential& potential, const Positions& x);
    /// Whether there is a factor for the shell as it is.
    bool has_factor() const { return !sources.empty(); }
    /// Iterations that take as long as a factorization. forces: what an iteration takes beside the solution,
    /// in entries of a factor that take as long.
    double iterations_per_factorization(double hessian, double forces) const {
        return system.iterations_per_factorization(hessian, forces);
    }
    /// Looks at how vertices have turned at x, and drops the patch.
    void turn(const Potential& potential, const Positions& x);
    enum class Fit { fits, patched, needs_factor };
    /// Whether the system fits the contacts at x; a patch is made where it does not.
    Fit fit(const Potential& potential, const Positions& x);
    /// Solves with the factor. right_side: N, [3, V].
    Positions solve(const Potential& potential, const Positions& right_side);
    /// Vertices that are born take their parent's part; a factor of other triangles is dropped.
    void topology_changed(const ShellChange& change);
    void visit_state(StateVisitor& visit);

  private:
    /// What contact had in the system at some place of a search.
    struct Fitted {
        std::vector<Matrix3d> stiffness;  ///< [V] N/m, diagonal blocks
        Positions x;                      ///< m, [3, V]; empty: not a place of this search
    };

    Positions solve_lagged(const Potential& potential, const Positions& right_side);
    /// Whether what contact has at a vertex is not what is known of it, but for little beside the vertex's
    /// block in the factor, and for a part of what is known.
    bool differ(std::size_t vertex, const Matrix3d& stiffness, const Matrix3d& known, double part) const;
    /// Whether at each vertex contact is like in one of the last `count` systems of this search.
    bool is_known(const std::vector<Matrix3d>& stiffness, std::size_t count) const;
    /// The vertices where contact, or what a patch has beside it, differs from the factor, and those around
    /// them, [V].
    std::vector<char> changed(const Shell& shell, const std::vector<Matrix3d>& stiffness) const;
    /// Begins to know what fits, at x or where the factor was made.
    void forget(Positions x = {});

    Threads threads;
    NewtonSystem system;
    bool outdated = true;             ///< whether the matrix has the pattern of another shell
    std::vector<Index> sources;       ///< [V] of each vertex that in the factor; empty: there is no factor
    std::vector<char> cracked;        ///< [V] whether a crack has changed the sheet there since
    std::vector<Matrix3d> frames;     ///< [F] inverse, at the time of the factor
    std::vector<Matrix3d> turns;      ///< [V] since then; empty: none
    VectorXd of_piece;                ///< [V] N/m, see inertia_of_pieces()
    std::vector<Matrix3d> in_factor;  ///< [V] N/m, contact's part of them
    std::deque<Fitted> fitted;        ///< the last ones of a search; the last of them is the system now
    bool fits_two = false;            ///< whether the patch has half of the one before it, too
    VertexGraph graph;                ///< of the shell as it is; empty: not made yet
    HessianPatch patch;
};

}  // namespace sherd
