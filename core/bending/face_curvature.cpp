// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/bending/face_curvature.h"

#include <Eigen/QR>
#include <algorithm>

namespace sherd {
namespace {

/// Returns the curvature of a face after it has bent at its free sides such that the energy is least. The
/// bending at each free side adds a multiple of the side's column of `free` to `curvature`.
Vector3d relaxed(const Vector3d& curvature, const Eigen::Matrix3Xd& free, const Matrix3d& elasticity) {
    const Matrix3d root = elasticity.llt().matrixU();
    const Eigen::ColPivHouseholderQR<Eigen::Matrix3Xd> bent(root * free);
    return curvature - free * bent.solve(root * curvature);
}

}  // namespace

FaceCurvature::FaceCurvature(const Shell& shell, const Folds& folds)
    : shell(shell),
      folds(folds),
      patches(shell, folds),
      shares(shell.edge_hinge.size()),
      faces(shell.triangles.size()) {
    for (const Index edge : shell.hinge_edge) shares[edge] = shares_of(edge);
    for (Index face = 0; face < static_cast<Index>(faces.size()); ++face) update_face(face);
}

std::vector<Index> FaceCurvature::follow(const ShellChange& change) {
    const Patches::Change seen = patches.follow(change);
    if (seen.more_mirrors > 0) renumber(seen);
    shares.resize(shell.edge_hinge.size());
    faces.resize(shell.triangles.size());
    std::vector<Index> changed = seen.faces;
    for (std::size_t edge = 0; edge < shares.size(); ++edge) {
        if (!shares[edge].empty() && !seen.concerns(shares[edge])) continue;
        const auto sides = patches.sides_of(static_cast<Index>(edge));
        shares[edge].clear();
        if (!sides) continue;
        shares[edge] = shares_of(static_cast<Index>(edge));
        for (const auto& [triangle, corner] : *sides) changed.push_back(triangle);
    }
    std::ranges::sort(changed);
    changed.erase(std::unique(changed.begin(), changed.end()), changed.end());
    for (const Index face : changed) update_face(face);
    return changed;
}

void FaceCurvature::renumber(const Patches::Change& change) {
    for (auto& of_edge : shares)
        for (Patches::Share& share : of_edge) share.fold = change.now(share.fold);
    for (auto& terms : faces)
        for (Term& term : terms) term.fold = change.now(term.fold);
}

std::vector<Patches::Share> FaceCurvature::shares_of(Index edge) const {
    const auto [first, second] = *patches.sides_of(edge);
    const PlaneTriangle &near = patches.triangle(first.triangle), &far = patches.triangle(second.triangle);
    // Without other folds, the angle is shared as for a constant curvature across the edge.
    const double height = height_over_side(near, first.corner);
    const double own = height / (height + height_over_side(far, second.corner));
    return patches.shares(first, tangent_angle(near, first.corner),
                          Patches::Share{folds_of_edges() + edge, own});
}

Matrix3d FaceCurvature::per_tangent(Index face) const {
    Matrix3d curvatures = Matrix3d::Zero();
    Eigen::Matrix3Xd free(3, 0);
    for (int side = 0; side < 3; ++side) {
        const Vector3d curvature = curvature_of_tangent(patches.triangle(face), side);
        if (patches.fold_at(face, side) >= 0) {
            curvatures.col(side) = curvature;
        } else {
            free.conservativeResize(Eigen::NoChange, free.cols() + 1);
            free.rightCols<1>() = curvature;
        }
    }
    if (free.cols() == 0) return curvatures;
    const Matrix3d& elasticity = shell.triangles[face].membrane.elasticity;
    for (int side = 0; side < 3; ++side)
        if (patches.fold_at(face, side) >= 0)
            curvatures.col(side) = relaxed(curvatures.col(side), free, elasticity);
    return curvatures;
}

std::vector<Index> FaceCurvature::folds_of(std::span<const Index> some) const {
    std::vector<Index> all;
    for (const Index face : some)
        for (const Term& term : faces[face]) all.push_back(term.fold);
    std::ranges::sort(all);
    all.erase(std::unique(all.begin(), all.end()), all.end());
    return all;
}

void FaceCurvature::update_face(Index face) {
    std::vector<Term>& terms = faces[face];
    terms.clear();
    const auto add = [&terms](Index fold, const Vector3d& per_angle) {
        const auto known = std::ranges::find(terms, fold, &Term::fold);
        if (known == terms.end())
            terms.push_back({fold, per_angle});
        else
            known->per_angle += per_angle;
    };
    const Matrix3d curvatures = per_tangent(face);
    for (int side = 0; side < 3; ++side) {
        const Index fold = patches.fold_at(face, side);
        const Vector3d curvature = curvatures.col(side);
        if (fold < 0) continue;
        if (fold < folds_of_edges()) {
            add(fold, 0.5 * curvature);
        } else {
            const bool of_first = is_first(fold - folds_of_edges(), {face, side});
            if (!of_first) add(fold, curvature);
            for (const Patches::Share& share : shares[fold - folds_of_edges()])
                add(share.fold, (of_first ? share.weight : -share.weight) * curvature);
        }
    }
}

}  // namespace sherd
