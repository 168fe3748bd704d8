// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/vibration/rigid_motions.h"

#include <Eigen/QR>
#include <Eigen/SVD>
#include <Eigen/SparseCore>
#include <limits>
#include <numeric>

#include "core/shell/supports.h"

namespace sherd {
namespace {

using Eigen::MatrixXd;
using RigidColumns = Eigen::Matrix<double, Eigen::Dynamic, 6>;

/// The vertices of each connected piece, ascending.
std::vector<std::vector<Index>> pieces_of(const Shell& shell) {
    std::vector<Index> root(shell.mass.size());
    std::iota(root.begin(), root.end(), Index{0});
    const auto root_of = [&](Index v) {
        while (root[v] != v) v = root[v] = root[root[v]];
        return v;
    };
    for (const TriangleStencil& triangle : shell.triangles)
        for (int c = 1; c < 3; ++c) {
            const Index a = root_of(triangle.vertices[0]), b = root_of(triangle.vertices[c]);
            root[std::max(a, b)] = std::min(a, b);
        }
    std::vector<Index> number(root.size(), -1);
    std::vector<std::vector<Index>> pieces;
    for (Index v = 0; v < static_cast<Index>(root.size()); ++v) {
        Index& piece = number[root_of(v)];
        if (piece < 0) {
            piece = static_cast<Index>(pieces.size());
            pieces.emplace_back();
        }
        pieces[piece].push_back(v);
    }
    return pieces;
}

/// Three translations and three rotations of a piece, times sqrt(m), as orthonormal columns over its
/// vertices.
RigidColumns rigid_columns(const Shell& shell, const Positions& x, std::span<const Index> piece) {
    Vector3d centre = Vector3d::Zero();
    for (const Index v : piece) centre += x.col(v) / static_cast<double>(piece.size());
    RigidColumns columns(3 * static_cast<Eigen::Index>(piece.size()), 6);
    for (std::size_t i = 0; i < piece.size(); ++i) {
        const double root_mass = std::sqrt(shell.mass[piece[i]]);
        const auto row = static_cast<Eigen::Index>(3 * i);
        columns.block<3, 3>(row, 0) = root_mass * Matrix3d::Identity();
        columns.block<3, 3>(row, 3) = -root_mass * cross_matrix(x.col(piece[i]) - centre);
    }
    const Eigen::HouseholderQR<MatrixXd> factors(columns);
    return factors.householderQ() * MatrixXd::Identity(columns.rows(), 6);
}

/// Rows of the vertices of a piece.
template <class Columns>
RigidColumns rows_of(const Columns& all, std::span<const Index> piece) {
    RigidColumns some(3 * static_cast<Eigen::Index>(piece.size()), 6);
    for (std::size_t i = 0; i < piece.size(); ++i)
        some.middleRows<3>(static_cast<Eigen::Index>(3 * i)) = all.template middleRows<3>(3 * piece[i]);
    return some;
}

/// Returns, for each column of `motions` (displacements times sqrt(m)), the part that supports block, and the
/// force with which the stiffness resists the other part, over `fastest` (free_rigid_motions()).
std::array<RigidColumns, 2> resisted(const Shell& shell, const BlockMatrix& stiffness, double fastest,
                                     const RigidColumns& motions) {
    std::array<RigidColumns, 2> result{motions, motions};
    const VectorXd root_mass = shell.mass.cwiseSqrt();
    for (int c = 0; c < 6; ++c) {
        Positions free = motions.col(c).reshaped(3, shell.mass.size());
        constrain(shell, free);
        result[0].col(c) -= free.reshaped();
        free *= root_mass.cwiseInverse().asDiagonal();
        Positions force = product(stiffness, free.reshaped()).reshaped(3, shell.mass.size());
        constrain(shell, force);
        force *= root_mass.cwiseInverse().asDiagonal();
        result[1].col(c) = force.reshaped() / fastest;
    }
    return result;
}

/// Round-off of a stiffness over the largest stiffness: the error of strain at rest is the error of positions
/// over the length of edges.
double round_off(const Shell& shell, const Positions& x) {
    double edges = 0;
    for (const TriangleStencil& triangle : shell.triangles)
        edges += std::sqrt(triangle.membrane.area) / static_cast<double>(shell.triangles.size());
    return 100 * std::numeric_limits<double>::epsilon() * (1 + x.cwiseAbs().maxCoeff() / edges);
}

}  // namespace

VectorXd product(const BlockMatrix& matrix, const VectorXd& x) {
    const Eigen::Map<const Eigen::SparseMatrix<double>> lower(
        matrix.size(), matrix.size(), static_cast<Index>(matrix.values().size()), matrix.columns().data(),
        matrix.rows().data(), matrix.values().data());
    return lower.selfadjointView<Eigen::Lower>() * x;
}

MatrixXd free_rigid_motions(const Shell& shell, const Positions& x, const BlockMatrix& stiffness,
                            double fastest) {
    const std::vector<std::vector<Index>> pieces = pieces_of(shell);
    // The stiffness couples no two pieces, so that one product serves all of them.
    RigidColumns motions = RigidColumns::Zero(3 * shell.mass.size(), 6);
    for (const std::vector<Index>& piece : pieces) {
        const RigidColumns own = rigid_columns(shell, x, piece);
        for (std::size_t i = 0; i < piece.size(); ++i)
            motions.middleRows<3>(3 * piece[i]) = own.middleRows<3>(static_cast<Eigen::Index>(3 * i));
    }
    const auto [blocked, stiff] = resisted(shell, stiffness, fastest, motions);
    const double threshold = round_off(shell, x);
    MatrixXd free(3 * shell.mass.size(), 0);
    for (const std::vector<Index>& piece : pieces) {
        MatrixXd both(6 * piece.size(), 6);
        both << rows_of(blocked, piece), rows_of(stiff, piece);
        const MatrixXd triangle = Eigen::HouseholderQR<MatrixXd>(both).matrixQR().topRows<6>();
        const Eigen::JacobiSVD<MatrixXd> parts(triangle.triangularView<Eigen::Upper>().toDenseMatrix(),
                                               Eigen::ComputeFullV);
        const Eigen::Index rank = (parts.singularValues().array() > threshold).count();
        if (rank == 6) continue;
        const MatrixXd own = rows_of(motions, piece) * parts.matrixV().rightCols(6 - rank);
        free.conservativeResize(Eigen::NoChange, free.cols() + own.cols());
        free.rightCols(own.cols()).setZero();
        for (std::size_t i = 0; i < piece.size(); ++i)
            free.middleRows<3>(3 * piece[i]).rightCols(own.cols()) =
                own.middleRows<3>(static_cast<Eigen::Index>(3 * i));
    }
    return free;
}

}  // namespace sherd
