// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/bending/coupled_cubic_bending.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/bending/cubic_face.h"
#include "core/shell/thickness.h"

namespace sherd {
namespace {

/// Where polynomials are safe: below this angle of folds at rest, and this thickness over the shortest side.
constexpr double sharpest_fold = std::numbers::pi / 4, thickest = 0.25;

double shortest_side(const TrianglePositions& x) {
    return std::sqrt(std::min({(x.col(1) - x.col(0)).squaredNorm(), (x.col(2) - x.col(1)).squaredNorm(),
                               (x.col(0) - x.col(2)).squaredNorm()}));
}

Eigen::MatrixXd positive_part(const Eigen::MatrixXd& symmetric) {
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(symmetric);
    return solver.eigenvectors() * solver.eigenvalues().cwiseMax(0).asDiagonal() *
           solver.eigenvectors().transpose();
}

}  // namespace

CoupledCubicBending::CoupledCubicBending(const Shell& shell, const std::vector<MirrorHinge>& mirrors)
    : shell(shell), angles(shell, mirrors), form(shell.triangles.size()), of_face(shell.triangles.size()) {
    for (Index face = 0; face < static_cast<Index>(form.size()); ++face) update(face);
    assemble();
}

void CoupledCubicBending::topology_changed(const ShellChange& change, const StepContext&) {
    const std::vector<Index> changed = angles.follow(change);
    form.resize(shell.triangles.size());
    of_face.resize(shell.triangles.size());
    for (const Index face : changed) update(face);
    assemble();
}

std::vector<Index> CoupledCubicBending::folds_of(Index face) const {
    std::vector<Index> folds;
    for (const FaceCurvature::Term& term : angles.face_curvature().terms(face)) folds.push_back(term.fold);
    return folds;
}

CoupledCubicBending::Form CoupledCubicBending::form_of(Index face, const std::vector<Index>& folds) const {
    const Folds& all = angles.all_folds();
    if (std::ranges::any_of(folds, [&](Index fold) { return fold < all.folds_of_edges(); }))
        return Form::beside_mirror;
    if (std::ranges::any_of(folds,
                            [&](Index fold) { return std::abs(all.rest_angle(fold)) >= sharpest_fold; }))
        return Form::crease;
    const std::array<Index, 3>& vertices = shell.triangles[face].vertices;
    if (mean_thickness(shell, vertices) > thickest * shortest_side(columns(shell.rest, vertices)))
        return Form::thick;
    return Form::polynomial;
}

/// The second derivatives of the face's energy by the angles of the joints.
Eigen::MatrixXd CoupledCubicBending::stiffness(Index face, const FoldTree& tree) const {
    const auto terms = angles.face_curvature().terms(face);
    Eigen::Matrix3Xd per_angle(3, tree.joints.size());
    for (std::size_t j = 0; j < tree.joints.size(); ++j)
        per_angle.col(static_cast<Eigen::Index>(j)) =
            std::ranges::find(terms, tree.joints[j].fold, &FaceCurvature::Term::fold)->per_angle;
    return per_angle.transpose() * angles.rigidity(face) * per_angle;
}

void CoupledCubicBending::update(Index face) {
    FacePolynomial& result = of_face[face] = {};
    const std::vector<Index> folds = folds_of(face);
    form[face] = form_of(face, folds);
    if (form[face] != Form::polynomial || folds.empty()) return;
    const FoldTree tree = fold_tree(angles.face_curvature().around(), angles.all_folds(), face, folds);
    Positions rest(3, tree.corners.size());
    for (std::size_t v = 0; v < tree.corners.size(); ++v) {
        const auto [triangle, corner] = tree.corners[v];
        rest.col(static_cast<Eigen::Index>(v)) = shell.rest.col(shell.triangles[triangle].vertices[corner]);
    }
    const bool whole = tree.joints.size() == folds.size();
    const auto cubic = whole ? cubic_face(tree, rest, stiffness(face, tree)) : std::nullopt;
    if (!cubic) {
        form[face] = Form::unsuited;
        return;
    }
    const Eigen::MatrixXd convex = positive_part(cubic->quadratic);
    result.corners = tree.corners;
    for (Eigen::Index a = 0; a < convex.rows(); ++a)
        for (Eigen::Index b = 0; b < a; ++b)
            result.springs.push_back({-cubic->quadratic(a, b), -convex(a, b)});
    for (std::size_t j = 0; j < tree.joints.size(); ++j)
        result.triples.emplace_back(tree.joints[j].fold - angles.all_folds().folds_of_edges(),
                                    cubic->cubic[static_cast<Eigen::Index>(j)]);
    result.constant = cubic->constant;
}

/// Sums in the order of faces, so that what comes out does not depend on the cracks' history.
void CoupledCubicBending::assemble() {
    std::vector<CubicPolynomial::Spring> springs;
    std::vector<double> cubic(shell.edge_hinge.size(), 0);
    double constant = 0;
    for (const FacePolynomial& face : of_face) {
        std::vector<Index> vertices;
        for (const auto& [triangle, corner] : face.corners)
            vertices.push_back(shell.triangles[triangle].vertices[corner]);
        auto spring = face.springs.begin();
        for (std::size_t a = 0; a < vertices.size(); ++a)
            for (std::size_t b = 0; b < a; ++b, ++spring)
                if (vertices[a] != vertices[b])
                    springs.push_back({vertices[a], vertices[b], (*spring)[0], (*spring)[1]});
        for (const auto& [edge, factor] : face.triples) cubic[edge] += factor;
        constant += face.constant;
    }
    std::vector<CubicPolynomial::Triple> triples;
    for (std::size_t h = 0; h < shell.hinges.size(); ++h)
        if (const double factor = cubic[shell.hinge_edge[h]]; factor != 0)
            triples.push_back({shell.hinges[h].vertices, factor});
    polynomial = CubicPolynomial(springs, std::move(triples), constant, shell.rest);

    std::vector<Index> others;
    for (Index face = 0; face < static_cast<Index>(form.size()); ++face)
        if (form[face] != Form::polynomial) others.push_back(face);
    angles.count_only(std::move(others));
}

void CoupledCubicBending::add_gradient(const Positions& x, Positions& gradient) const {
    angles.add_gradient(x, gradient);
    polynomial.add_gradient(x, gradient);
}

void CoupledCubicBending::add_hessian(const Positions& x, Curvature curvature, BlockMatrix& hessian) const {
    angles.add_hessian(x, curvature, hessian);
    polynomial.add_hessian(x, curvature, hessian);
}

void CoupledCubicBending::add_pattern(std::vector<std::pair<Index, Index>>& pairs) const {
    angles.add_pattern(pairs);
    polynomial.add_pattern(pairs);
}

const CoupledBending* coupled_hinges(const Energy& bending) {
    if (const auto* cubic = dynamic_cast<const CoupledCubicBending*>(&bending)) return &cubic->hinges();
    return dynamic_cast<const CoupledBending*>(&bending);
}

}  // namespace sherd
