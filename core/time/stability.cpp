// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/time/stability.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <numeric>

#include "core/bending/cubic_bending.h"
#include "core/membrane/membrane_energy.h"
#include "core/shell/triangle_edge.h"
#include "core/solver/linear/linear_solver.h"
#include "core/solver/potential.h"
#include "core/time/inertia.h"
#include "core/time/schemes/implicit_euler.h"

namespace sherd {
namespace {

constexpr double growth_time = 0.1;  // s; instabilities that take longer to grow are tolerated

/// Whether the rest shape has the least energy for any material: the energy is a sum of squares that are zero
/// at rest.
bool is_least_at_rest(BendingModel model) {
    return model == BendingModel::coupled || model == BendingModel::nonlinear;
}

/// Parts of the stiffness at rest, one for each cubic hinge of a curved sheet: the stiffness of the hinge,
/// and shares of the stiffness of its triangles and of the inertia of its vertices.
class HingeParts {
  public:
    explicit HingeParts(const Shell& shell)
        : shell(shell), hinges(shell.hinges, shell.rest), membrane{&shell.triangles} {
        for (Index i = 0; i < static_cast<Index>(hinges.size()); ++i)
            if (hinges.hinges[i].cubic != 0) curved.push_back(i);
        std::vector<Index> faces(shell.triangles.size());
        std::iota(faces.begin(), faces.end(), 0);
        sides = sides_of_hinges(shell, curved, faces);
        around_face.assign(faces.size(), 0);
        around_vertex.assign(shell.rest.cols(), 0);
        for (std::size_t i = 0; i < curved.size(); ++i) {
            for (const TriangleEdge& side : sides[i]) ++around_face[side.triangle];
            for (const Index vertex : hinges.vertices(curved[i])) ++around_vertex[vertex];
        }
    }
    std::size_t size() const { return curved.size(); }
    HingeHessian stiffness(std::size_t part) const;

  private:
    const Shell& shell;
    CubicHinges hinges;
    MembraneElements membrane;
    std::vector<Index> curved;                       ///< hinges with a cubic part
    std::vector<std::array<TriangleEdge, 2>> sides;  ///< sides of each of the curved hinges
    /// Number of curved hinges at each face, and at each vertex.
    std::vector<int> around_face, around_vertex;
};

HingeHessian HingeParts::stiffness(std::size_t part) const {
    const std::array<Index, 4>& vertices = hinges.vertices(curved[part]);
    HingeHessian sum = hinges.hessian(curved[part], hinges.at_rest(curved[part]), Curvature::exact);
    for (int v = 0; v < 4; ++v) {
        const double mass = shell.mass[vertices[v]] / around_vertex[vertices[v]];
        sum.diagonal().segment<3>(3 * v).array() += mass / (growth_time * growth_time);
    }
    for (const TriangleEdge& side : sides[part]) {
        const std::array<Index, 3>& corners = membrane.vertices(side.triangle);
        const Eigen::Matrix<double, 9, 9> of_face =
            membrane.hessian(side.triangle, columns(shell.rest, corners), Curvature::exact) /
            around_face[side.triangle];
        std::array<Eigen::Index, 3> at{};
        for (int c = 0; c < 3; ++c) at[c] = 3 * (std::ranges::find(vertices, corners[c]) - vertices.begin());
        for (int a = 0; a < 3; ++a)
            for (int b = 0; b < 3; ++b) sum.block<3, 3>(at[a], at[b]) += of_face.block<3, 3>(3 * a, 3 * b);
    }
    return sum;
}

/// Whether the stiffness of each of the HingeParts is positive definite. The stiffness of flat hinges is
/// never negative, so that the whole stiffness at rest then is positive definite, too.
bool parts_are_stable(const Shell& shell) {
    const HingeParts parts(shell);
    for (std::size_t i = 0; i < parts.size(); ++i)
        if (parts.stiffness(i).llt().info() != Eigen::Success) return false;
    return true;
}

/// Whether the stiffness at rest of cubic hinges and membrane is positive definite. Inertia on the diagonal,
/// as in an implicit Euler step of `growth_time`, outweighs instabilities that grow more slowly.
bool whole_is_stable(const Shell& shell, MembraneModel membrane_model) {
    const std::unique_ptr<Energy> bending =
        bending_energy(shell, {BendingModel::cubic, BendingJacobian::cubic});
    const std::unique_ptr<Energy> membrane = membrane_energy(shell, membrane_model);
    TimeSpent spent;
    Inertia inertia(shell, Vector3d::Zero());
    inertia.begin(ImplicitEuler().begin(shell, {}, 0, growth_time));
    const Potential potential(shell, {&inertia, bending.get(), membrane.get()}, spent);
    BlockMatrix stiffness = potential.hessian_pattern(shell.rest);
    potential.hessian(shell.rest, Curvature::exact, stiffness);
    const std::unique_ptr<LinearSolver> solver = cholesky_solver();
    solver->analyze(stiffness);
    return solver->factorize(stiffness);
}

}  // namespace

bool stable_at_rest(const Shell& shell, BendingModel model, MembraneModel membrane) {
    if (is_least_at_rest(model)) return true;
    const bool by_parts = membrane == MembraneModel::constant_strain;
    return (by_parts && parts_are_stable(shell)) || whole_is_stable(shell, membrane);
}

}  // namespace sherd
