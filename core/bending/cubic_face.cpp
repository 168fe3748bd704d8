// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/bending/cubic_face.h"

#include <Eigen/LU>
#include <Eigen/QR>
#include <cmath>

#include "core/elements/triple_product.h"

namespace sherd {
namespace {

using Eigen::MatrixXd;

/// Bound on P over S, and on the error of linear equations that have an exact solution. P grows beyond S, and
/// stiffens what stretches the sheet, as normals around the face come near to a right angle.
constexpr double largest_growth = 2, largest_error = 1e-9;

/// The vectors u_j = (t0 + t1) / l of the joints at rest, which are linear in the positions, with their
/// derivatives by the angles of the joints when each turns all that hangs at it (t0, t1: outward edge
/// normals of length l, paper, section 3).
class TurningNormals {
  public:
    TurningNormals(const FoldTree& tree, const Positions& rest);
    Eigen::Index size() const { return count; }
    double angle(Eigen::Index joint) const { return hinges[joint].angle; }
    /// What the positions count in u_j, [N], 1/m.
    VectorXd weights(Eigen::Index joint, Eigen::Index vertices) const;
    /// sin(angle) over the triple product, 1/m^3.
    double sine_of_triple(Eigen::Index joint) const;
    /// d(u_e . u_f) / d(angle g) and d2(u_e . u_f) / d(angle g) d(angle h).
    double slope(Eigen::Index e, Eigen::Index f, Eigen::Index g) const {
        return first(g, e).dot(normals.col(f)) + normals.col(e).dot(first(g, f));
    }
    double curvature(Eigen::Index e, Eigen::Index f, Eigen::Index g, Eigen::Index h) const {
        return second(g, h, e).dot(normals.col(f)) + normals.col(e).dot(second(g, h, f)) +
               first(g, e).dot(first(h, f)) + first(h, e).dot(first(g, f));
    }

  private:
    using Columns = Eigen::Matrix3Xd;
    Vector3d first(Eigen::Index g, Eigen::Index e) const { return firsts.col(g * count + e); }
    Vector3d second(Eigen::Index g, Eigen::Index h, Eigen::Index e) const {
        return seconds.col((g * count + h) * count + e);
    }
    void add_normal(const FoldTree& tree, Eigen::Index joint, int triangle, const Vector3d& normal);

    const FoldTree& tree;
    Eigen::Index count;
    std::vector<RestHinge> hinges;
    Columns axes;  ///< about which the outer triangles turn
    Columns normals, firsts, seconds;
};

TurningNormals::TurningNormals(const FoldTree& tree, const Positions& rest)
    : tree(tree), count(static_cast<Eigen::Index>(tree.joints.size())) {
    axes.resize(3, count);
    normals = Columns::Zero(3, count);
    firsts = Columns::Zero(3, count * count);
    seconds = Columns::Zero(3, count * count * count);
    for (Eigen::Index j = 0; j < count; ++j) {
        const HingePositions x = columns(rest, tree.joints[j].vertices);
        hinges.push_back(rest_hinge(x));
        axes.col(j) = (x.col(0) - x.col(1)) / hinges[j].edge_length;
    }
    for (Eigen::Index j = 0; j < count; ++j) {
        const HingePositions x = columns(rest, tree.joints[j].vertices);
        const auto& c = hinges[j].cotangents;
        const double length = hinges[j].edge_length;
        add_normal(tree, j, tree.joints[j].inner,
                   -(c[1] * (x.col(2) - x.col(0)) + c[0] * (x.col(2) - x.col(1))) / length);
        add_normal(tree, j, static_cast<int>(j) + 1,
                   -(c[3] * (x.col(3) - x.col(0)) + c[2] * (x.col(3) - x.col(1))) / length);
    }
}

/// A normal turns with its triangle: by all joints on the way to it from the face, the nearest one last.
void TurningNormals::add_normal(const FoldTree& tree, Eigen::Index joint, int triangle,
                                const Vector3d& normal) {
    normals.col(joint) += normal;
    for (int outer = triangle; outer > 0; outer = tree.joints[outer - 1].inner) {
        const Eigen::Index h = outer - 1;
        const Vector3d turned = axes.col(h).cross(normal);
        firsts.col(h * count + joint) += turned;
        for (int nearer = outer; nearer > 0; nearer = tree.joints[nearer - 1].inner) {
            const Eigen::Index g = nearer - 1;
            const Vector3d twice = axes.col(g).cross(turned);
            seconds.col((g * count + h) * count + joint) += twice;
            if (g != h) seconds.col((h * count + g) * count + joint) += twice;
        }
    }
}

VectorXd TurningNormals::weights(Eigen::Index joint, Eigen::Index vertices) const {
    const auto& c = hinges[joint].cotangents;
    const Eigen::Vector4d of_hinge(c[1] + c[3], c[0] + c[2], -c[0] - c[1], -c[2] - c[3]);
    VectorXd all = VectorXd::Zero(vertices);
    for (int v = 0; v < 4; ++v) all[tree.joints[joint].vertices[v]] = of_hinge[v] / hinges[joint].edge_length;
    return all;
}

double TurningNormals::sine_of_triple(Eigen::Index joint) const {
    const auto& c = hinges[joint].cotangents;
    return (c[0] + c[1]) * (c[2] + c[3]) / std::pow(hinges[joint].edge_length, 3);
}

/// E = 1/2 sum_ef P_ef u_e . u_f - sum_j m_j sin(angle_j).
struct AngularPolynomial {
    MatrixXd products;  ///< P, N m
    VectorXd sines;     ///< m, N m
};

/// The polynomial without a slope at rest whose second derivatives by the angles are S there: as many linear
/// equations as unknowns.
std::optional<AngularPolynomial> angular_polynomial(const TurningNormals& u, const MatrixXd& stiffness) {
    const Eigen::Index n = u.size(), pairs = n * (n + 1) / 2;
    MatrixXd system = MatrixXd::Zero(pairs + n, pairs + n);
    VectorXd right = VectorXd::Zero(pairs + n);
    for (Eigen::Index e = 0, column = 0; e < n; ++e)
        for (Eigen::Index f = e; f < n; ++f, ++column) {
            const double count = e == f ? 0.5 : 1;
            for (Eigen::Index g = 0, row = n; g < n; ++g) {
                system(g, column) = count * u.slope(e, f, g);
                for (Eigen::Index h = g; h < n; ++h, ++row)
                    system(row, column) = count * u.curvature(e, f, g, h);
            }
        }
    for (Eigen::Index g = 0, row = n; g < n; ++g) {
        system(g, pairs + g) = -std::cos(u.angle(g));
        system(row, pairs + g) = std::sin(u.angle(g));
        for (Eigen::Index h = g; h < n; ++h, ++row) right[row] = stiffness(g, h);
    }
    const Eigen::PartialPivLU<MatrixXd> factor(system);
    const VectorXd solution = factor.solve(right);
    if (!((system * solution - right).norm() <= largest_error * right.norm())) return std::nullopt;
    AngularPolynomial result{MatrixXd(n, n), solution.tail(n)};
    for (Eigen::Index e = 0, column = 0; e < n; ++e)
        for (Eigen::Index f = e; f < n; ++f, ++column)
            result.products(e, f) = result.products(f, e) = solution[column];
    if (!(result.products.norm() <= largest_growth * stiffness.norm())) return std::nullopt;
    return result;
}

/// The edges of the tree's triangles, each once.
std::vector<std::array<int, 2>> edges_of(const FoldTree& tree) {
    std::vector<std::array<int, 2>> edges{{0, 1}, {1, 2}, {2, 0}};
    for (const auto& [fold, inner, vertices] : tree.joints) {
        edges.push_back({vertices[0], vertices[3]});
        edges.push_back({vertices[1], vertices[3]});
    }
    return edges;
}

double sum_of_triples(const CubicFace& face, const FoldTree& tree, const Positions& x) {
    double sum = 0;
    for (std::size_t j = 0; j < tree.joints.size(); ++j)
        sum += face.cubic[static_cast<Eigen::Index>(j)] * triple_product(columns(x, tree.joints[j].vertices));
    return sum;
}

Positions force_at(const CubicFace& face, const FoldTree& tree, const Positions& x) {
    Positions force = x * face.quadratic;
    for (std::size_t j = 0; j < tree.joints.size(); ++j) {
        const auto& vertices = tree.joints[j].vertices;
        const HingePositions of_joint = triple_gradient(columns(x, vertices));
        for (int v = 0; v < 4; ++v)
            force.col(vertices[v]) -= face.cubic[static_cast<Eigen::Index>(j)] * of_joint.col(v);
    }
    return force;
}

/// Subtracts multiples of the squares of the tree's edge lengths that cancel the gradient at rest. No motion
/// that leaves the triangles' shape feels this. Returns whether it succeeds.
bool bring_to_equilibrium(CubicFace& face, const FoldTree& tree, const Positions& rest) {
    const std::vector<std::array<int, 2>> edges = edges_of(tree);
    MatrixXd squares(rest.size(), edges.size());
    for (std::size_t j = 0; j < edges.size(); ++j) {
        const auto [p, q] = edges[j];
        Positions g = Positions::Zero(3, rest.cols());
        g.col(p) = 2 * (rest.col(p) - rest.col(q));
        g.col(q) = -g.col(p);
        squares.col(static_cast<Eigen::Index>(j)) = g.reshaped();
    }
    const VectorXd force = force_at(face, tree, rest).reshaped();
    const VectorXd a = squares.colPivHouseholderQr().solve(force);
    const double size = face.quadratic.norm() * rest.norm();
    if (!((squares * a - force).norm() <= largest_error * size)) return false;
    for (std::size_t j = 0; j < edges.size(); ++j) {
        const auto [p, q] = edges[j];
        const double twice = 2 * a[static_cast<Eigen::Index>(j)];
        face.quadratic(p, p) -= twice;
        face.quadratic(q, q) -= twice;
        face.quadratic(p, q) += twice;
        face.quadratic(q, p) += twice;
    }
    return true;
}

}  // namespace

std::optional<CubicFace> cubic_face(const FoldTree& tree, const Positions& rest, const MatrixXd& stiffness) {
    const Positions x = rest.colwise() - Vector3d(rest.col(0));
    const TurningNormals normals(tree, x);
    const auto angular = angular_polynomial(normals, stiffness);
    if (!angular) return std::nullopt;
    const Eigen::Index joints = normals.size();
    MatrixXd weights(joints, x.cols());
    CubicFace face;
    face.cubic.resize(joints);
    for (Eigen::Index j = 0; j < joints; ++j) {
        weights.row(j) = normals.weights(j, x.cols());
        face.cubic[j] = angular->sines[j] * normals.sine_of_triple(j);
    }
    face.quadratic = weights.transpose() * angular->products * weights;
    if (!bring_to_equilibrium(face, tree, x)) return std::nullopt;
    face.constant = sum_of_triples(face, tree, x) - 0.5 * (x * face.quadratic).cwiseProduct(x).sum();
    return face;
}

}  // namespace sherd
