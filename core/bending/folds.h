// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "core/bending/mirror_hinge.h"
#include "core/elements/dihedral_angle.h"
#include "core/state_visitor.h"

namespace sherd {

/// The folds of a shell and their true dihedral angles: mirrors (clamps and symmetry planes), numbered from 0
/// in their order, then the shell's edges from folds_of_edges(). Where an edge has no hinge, its angle is
/// zero.
class Folds {
  public:
    /// A fold's angle, and its gradient by the positions of the sheet's vertices. The apex of a mirror image
    /// is no vertex.
    struct Slope {
        std::array<Index, 4> vertices;  ///< -1: no vertex
        double angle;                   ///< rad
        HingePositions gradient;        ///< gradient of the angle, 1/m
    };

    /// The shell must outlive this object.
    Folds(const Shell& shell, const std::vector<MirrorHinge>& mirrors)
        : shell(shell), mirrors(shell, mirrors) {}
    void begin(const StepContext& step) { mirrors.begin(step); }

    /// Number of edge 0 among the folds.
    Index folds_of_edges() const { return static_cast<Index>(mirrors.size()); }
    Eigen::Index size() const {
        return folds_of_edges() + static_cast<Eigen::Index>(shell.edge_hinge.size());
    }
    /// The side of a triangle at which a mirror is.
    const TriangleEdge& mirror_side(Index mirror) const { return mirrors[mirror].side; }
    const Mirrors& all_mirrors() const { return mirrors; }
    std::array<Index, 4> vertices(Index fold) const;  ///< -1: no vertex
    /// Appends the vertices of a fold that are not among `vertices` yet.
    void collect(Index fold, std::vector<Index>& vertices) const;

    double rest_angle(Index fold) const;        ///< rad
    VectorXd rest_angles() const;               ///< rest angles of all folds, rad
    VectorXd angles(const Positions& x) const;  ///< angles of all folds, rad
    /// Folds that have an angle: mirrors, then edges with a hinge, in the order of hinges.
    std::vector<Index> present() const;
    // The functions below that have a list `some` of present folds compute only the entries of these folds.
    // Other entries are zero in lists of angles, and undefined in lists of slopes.
    VectorXd angles(const Positions& x, std::span<const Index> some) const;
    std::vector<Slope> slopes(const Positions& x) const { return slopes(x, present()); }
    std::vector<Slope> slopes(const Positions& x, std::span<const Index> some) const {
        std::vector<Slope> all;
        find_slopes(x, some, all);
        return all;
    }
    /// Writes slopes to the buffer `all`, which is made large enough.
    void find_slopes(const Positions& x, std::span<const Index> some, std::vector<Slope>& all,
                     const Threads& threads = Threads()) const;
    /// Angles, rad, that `slopes` hold.
    VectorXd angles(std::span<const Slope> slopes, std::span<const Index> some) const;
    /// Adds the gradient, N, of an energy whose derivatives by the angles of all folds are of_angles, N m.
    void add_gradient(std::span<const Slope> slopes, const VectorXd& of_angles, Positions& gradient,
                      std::span<const Index> some) const;
    /// Must be called when the shell has changed. Where triangles have changed, there may be more mirrors
    /// than before.
    void follow(const ShellChange& change) { mirrors.follow(change); }
    /// Appends the rest angles of new edges to `angles`, a list for all folds; if triangles have changed, all
    /// angles become rest angles.
    void extend(const ShellChange& change, VectorXd& angles) const;

    /// Adds the contribution of the angles' second derivatives to the Hessian of an energy: see
    /// add_gradient() for of_angles.
    void add_hessian(const Positions& x, const VectorXd& of_angles, BlockMatrix& hessian) const {
        add_hessian(x, of_angles, hessian, present());
    }
    void add_hessian(const Positions& x, const VectorXd& of_angles, BlockMatrix& hessian,
                     std::span<const Index> some) const;
    /// Gradient, by the vertices of each mirror, of an energy: see add_gradient() for of_angles. Only mirrors
    /// exert a net force or torque: the forces of other folds on their vertices have neither.
    std::vector<MirrorGradient> mirror_gradients(const Positions& x, const VectorXd& of_angles) const;

    void visit_state(StateVisitor& visit) {
        auto& [shell, mirrors] = *this;
        visit(mirrors);
    }

  private:
    /// Positions of a fold's vertices at x, as of a hinge; the fourth vertex of a mirror is the image of its
    /// apex.
    HingePositions positions(Index fold, const Positions& x) const;
    Slope slope(Index fold, const Positions& x) const;

    const Shell& shell;
    Mirrors mirrors;
};

/// Appends all unordered pairs of different vertices.
inline void add_pairs(std::vector<std::pair<Index, Index>>& pairs, std::span<const Index> vertices) {
    for (std::size_t a = 0; a < vertices.size(); ++a)
        for (std::size_t b = 0; b < a; ++b) pairs.emplace_back(vertices[a], vertices[b]);
}

}  // namespace sherd
