// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/vibration/vibration.h"

#include <cmath>
#include <numbers>
#include <stdexcept>

#include "core/shell/supports.h"
#include "core/solver/linear/linear_solver.h"
#include "core/solver/potential.h"
#include "core/vibration/largest_eigenpairs.h"
#include "core/vibration/rigid_motions.h"

namespace sherd {
namespace {

constexpr double growth_of_shift = 10;  // factor of the shift if the matrix is not positive definite

/// Options for vibration: elastic energies with their exact second derivative, and loads at their full size.
ShellEnergyOptions vibrating(ShellEnergyOptions options) {
    options.bending.jacobian = exact_jacobian(options.bending.model);
    for (Load& load : options.loads) load.ramp = 0;
    options.winds.clear();
    options.damping = {};
    return options;
}

Index free_coordinates(const Shell& shell) {
    double sum = 0;
    for (Eigen::Index v = 0; v < shell.mass.size(); ++v)
        if (!shell.fixed[v]) sum += shell.guide[v] == 0 ? 3 : shell.guides[shell.guide[v] - 1].trace();
    return static_cast<Index>(std::lround(sum));
}

/// The largest diagonal entry of K over its mass, 1/s^2, which is about the highest omega^2.
double fastest(const Shell& shell, const BlockMatrix& stiffness) {
    double largest = 0;
    for (Index row = 0; row < stiffness.size(); ++row)
        if (!shell.fixed[row / 3])
            largest = std::max(largest, stiffness.values()[stiffness.columns()[row]] / shell.mass[row / 3]);
    return largest;
}

/// About omega^2 of the slowest bending of a free plate with the size and the mean thickness of the shell.
double slow_bending(const Shell& shell) {
    double stiffness = 0, area = 0;
    for (const HingeStencil& hinge : shell.hinges)
        stiffness += hinge.stiffness / static_cast<double>(shell.hinges.size());
    for (const TriangleStencil& triangle : shell.triangles) area += triangle.membrane.area;
    const double size = (shell.position.rowwise().maxCoeff() - shell.position.rowwise().minCoeff()).norm();
    return 100 * stiffness * area / (shell.mass.sum() * std::pow(size, 4));
}

[[noreturn]] void refuse() {
    throw std::runtime_error(
        "vibration: the stiffness is not finite; sherd check warns of implausible materials and triangles");
}

/// The stiffness K, and the factor of K + shift M with the masses M.
class ShiftedStiffness {
  public:
    ShiftedStiffness(const Shell& shell, ShellEnergies& energies)
        : shell(shell),
          potential(shell, all(energies), spent),
          matrix(pattern()),
          highest(fastest(shell, matrix)) {
        if (!std::isfinite(highest)) refuse();
    }

    const BlockMatrix& stiffness() const { return matrix; }
    double fastest_eigenvalue() const { return highest; }

    /// Factorizes the matrix. Returns the shift, 1/s^2: the first of a growing sequence with which the matrix
    /// is positive definite.
    double factorize() {
        const std::vector<double> unshifted(matrix.values().begin(), matrix.values().end());
        double shift = std::max(slow_bending(shell), 1e-14 * highest);
        solver->analyze(matrix);
        for (; shift < 100 * highest; shift *= growth_of_shift) {
            matrix.blend(unshifted, unshifted, 0);
            for (Index v = 0; v < static_cast<Index>(shell.mass.size()); ++v)
                matrix.add(v, v, shift * shell.mass[v] * Matrix3d::Identity());
            if (solver->factorize(matrix)) return shift;
        }
        refuse();
    }

    /// sqrt(M) (K + shift M)^-1 sqrt(M) y, zero in directions that supports block.
    VectorXd inverse(const VectorXd& y) const {
        Positions force = y.reshaped(3, shell.mass.size()) * shell.mass.cwiseSqrt().asDiagonal();
        constrain(shell, force);
        Positions moved = solver->solve(force.reshaped()).reshaped(3, shell.mass.size());
        constrain(shell, moved);
        moved *= shell.mass.cwiseSqrt().asDiagonal();
        return moved.reshaped();
    }

  private:
    static std::vector<Energy*> all(ShellEnergies& energies) {
        std::vector<Energy*> sum = energies.elastic();
        const std::vector<Energy*> loads = energies.loads();
        sum.insert(sum.end(), loads.begin(), loads.end());
        return sum;
    }
    BlockMatrix pattern() {
        potential.begin({0, 0, 0, shell.position, shell.velocity, {}});
        BlockMatrix hessian = potential.hessian_pattern(shell.position);
        potential.hessian(shell.position, Curvature::exact, hessian);
        return hessian;
    }

    const Shell& shell;
    TimeSpent spent;
    Potential potential;
    BlockMatrix matrix;
    double highest;
    std::unique_ptr<LinearSolver> solver = cholesky_solver();
};

/// The displacements u with sqrt(M) u = y, with the sign that makes their largest coordinate positive.
Positions shape_of(const Shell& shell, const VectorXd& y) {
    Positions shape = y.reshaped(3, shell.mass.size()) * shell.mass.cwiseSqrt().cwiseInverse().asDiagonal();
    constrain(shell, shape);
    Eigen::Index row = 0, column = 0;
    shape.cwiseAbs().maxCoeff(&row, &column);
    return shape(row, column) < 0 ? Positions(-shape) : shape;
}

}  // namespace

double VibrationMode::angular_frequency() const {
    return std::sqrt(std::max(eigenvalue, 0.0));
}

double VibrationMode::frequency() const {
    return angular_frequency() / (2 * std::numbers::pi);
}

double VibrationMode::growth_rate() const {
    return std::sqrt(std::max(-eigenvalue, 0.0));
}

Vibration vibration(const Shell& shell, const ShellEnergyOptions& options, Index count) {
    Vibration result;
    result.freedoms = free_coordinates(shell);
    if (result.freedoms == 0) return result;
    ShellEnergies energies(shell, vibrating(options));
    ShiftedStiffness shifted(shell, energies);
    const double scale = shifted.fastest_eigenvalue();
    const Eigen::MatrixXd rigid = free_rigid_motions(shell, shell.position, shifted.stiffness(), scale);
    result.rigid = static_cast<Index>(rigid.cols());
    const Index rank = result.freedoms - result.rigid;
    count = std::min(count, rank);
    if (count == 0) return result;
    const double shift = shifted.factorize();
    // The map is scaled, so that no eigenvalue is tiny: Lanczos' method has absolute thresholds, too.
    const auto map = [&](const VectorXd& y) -> VectorXd { return scale * shifted.inverse(y); };
    const Eigenpairs pairs = largest_eigenpairs(map, 3 * shell.mass.size(), rigid, rank, count);
    for (Eigen::Index i = 0; i < pairs.values.size(); ++i)
        result.modes.push_back({scale / pairs.values[i] - shift, shape_of(shell, pairs.vectors.col(i))});
    return result;
}

double share_along_normals(const Shell& shell, const Positions& x, const Positions& shape) {
    Positions normals = Positions::Zero(3, x.cols());
    for (const TriangleStencil& triangle : shell.triangles) {
        const TrianglePositions corner = columns(x, triangle.vertices);
        const Vector3d normal =
            Vector3d(corner.col(1) - corner.col(0)).cross(Vector3d(corner.col(2) - corner.col(0)));
        for (const Index v : triangle.vertices) normals.col(v) += normal;
    }
    double along = 0, all = 0;
    for (Eigen::Index v = 0; v < x.cols(); ++v) {
        along += shell.mass[v] * std::pow(normals.col(v).normalized().dot(shape.col(v)), 2);
        all += shell.mass[v] * shape.col(v).squaredNorm();
    }
    return along / all;
}

}  // namespace sherd
