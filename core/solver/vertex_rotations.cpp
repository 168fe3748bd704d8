// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/solver/vertex_rotations.h"

#include <Eigen/LU>
#include <cmath>

namespace sherd {
namespace {

constexpr int most_rounds = 12;
constexpr double close_enough = 1e-10;

/// Returns a matrix whose columns are two edges of a face and its normal, scaled to the square root of twice
/// the area, so that all columns have the unit of a length.
Matrix3d frame(const std::array<Index, 3>& vertices, const Positions& x) {
    Matrix3d columns;
    columns.col(0) = x.col(vertices[1]) - x.col(vertices[0]);
    columns.col(1) = x.col(vertices[2]) - x.col(vertices[0]);
    const Vector3d normal = columns.col(0).cross(columns.col(1));
    columns.col(2) = normal / std::sqrt(normal.norm());
    return columns;
}

/// The rotation of the polar decomposition, by Newton's iteration (Higham 1986); the identity if the
/// determinant is not positive or the iteration does not converge.
Matrix3d rotation(const Matrix3d& gradient) {
    const double determinant = gradient.determinant();
    if (!(determinant > 0)) return Matrix3d::Identity();
    Matrix3d turn = gradient / std::cbrt(determinant);
    for (int round = 0; round < most_rounds; ++round) {
        const Matrix3d next = 0.5 * (turn + turn.inverse().transpose());
        const double change = (next - turn).cwiseAbs().maxCoeff();
        turn = next;
        if (change < close_enough) return turn;
    }
    return Matrix3d::Identity();
}

}  // namespace

std::vector<Matrix3d> inverse_frames(const Shell& shell, const Positions& x) {
    std::vector<Matrix3d> frames;
    frames.reserve(shell.triangles.size());
    for (const TriangleStencil& triangle : shell.triangles) {
        const Matrix3d now = frame(triangle.vertices, x);
        const bool is_regular = now.allFinite() && now.determinant() > 0;
        frames.push_back(is_regular ? Matrix3d(now.inverse()) : Matrix3d::Zero());
    }
    return frames;
}

std::vector<Matrix3d> vertex_rotations(const Shell& shell, const std::vector<Matrix3d>& inverse_frames,
                                       const Positions& x) {
    std::vector<Matrix3d> turns(shell.mass.size(), Matrix3d::Zero());
    for (std::size_t t = 0; t < shell.triangles.size(); ++t) {
        const auto& [vertices, membrane] = shell.triangles[t];
        const Matrix3d gradient = membrane.area * frame(vertices, x) * inverse_frames[t];
        if (!gradient.allFinite()) continue;
        for (const Index vertex : vertices) turns[vertex] += gradient;
    }
    for (std::size_t v = 0; v < turns.size(); ++v)
        turns[v] = shell.fixed[v] || shell.guide[v] ? Matrix3d::Identity() : rotation(turns[v]);
    return turns;
}

}  // namespace sherd
