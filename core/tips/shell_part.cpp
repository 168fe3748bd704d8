// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tips/shell_part.h"

#include <algorithm>
#include <cmath>

#include "core/material/orthotropy.h"
#include "core/tips/crack_tip.h"

namespace sherd {
namespace {

Index number_in(const std::vector<Index>& sorted, Index value) {
    return static_cast<Index>(std::ranges::lower_bound(sorted, value) - sorted.begin());
}

/// The sides that a fold joins; a mirror has one.
std::vector<TriangleEdge> sides_of(const CoupledBending& bending, Index fold) {
    const Folds& folds = bending.all_folds();
    if (fold < folds.folds_of_edges()) return {folds.mirror_side(fold)};
    const auto sides = bending.face_curvature().around().sides_of(fold - folds.folds_of_edges());
    return sides ? std::vector<TriangleEdge>(sides->begin(), sides->end()) : std::vector<TriangleEdge>();
}

void add_faces(const Shell& shell, ShellPart& part) {
    for (const Index face : part.faces)
        for (const Index vertex : shell.triangles[face].vertices) part.vertices.push_back(vertex);
    make_unique(part.vertices);
    resize_vertices(part.shell, static_cast<Index>(part.vertices.size()));
    part.shell.rest = shell.rest(Eigen::all, part.vertices);
    part.shell.thickness = shell.thickness(part.vertices);
    part.shell.uneven = shell.uneven;
    for (const Index face : part.faces) {
        part.shell.triangles.push_back(shell.triangles[face]);
        for (Index& vertex : part.shell.triangles.back().vertices) vertex = number_in(part.vertices, vertex);
    }
}

void add_fold(const Shell& shell, const CoupledBending& bending, Index fold, ShellPart& part) {
    const Index of_edges = bending.all_folds().folds_of_edges();
    if (fold < of_edges) {
        auto [face, corner] = bending.all_folds().mirror_side(fold);
        // The only condition on the plane is that it contains the side.
        part.mirrors.push_back(clamp_hinge(part.shell, {number_in(part.faces, face), corner}, 0));
        return;
    }
    HingeStencil hinge = shell.hinges[shell.edge_hinge[fold - of_edges]];
    for (Index& vertex : hinge.vertices) vertex = number_in(part.vertices, vertex);
    part.shell.edge_hinge.push_back(static_cast<Index>(part.shell.hinges.size()));
    part.shell.hinge_edge.push_back(part.shell.edge_hinge.back());
    part.shell.hinges.push_back(hinge);
}

}  // namespace

ShellPart shell_part(const Shell& shell, const CoupledBending& bending, std::span<const Index> folds) {
    ShellPart part;
    part.folds.assign(folds.begin(), folds.end());
    make_unique(part.folds);
    for (const Index fold : part.folds)
        for (const TriangleEdge& side : sides_of(bending, fold)) part.faces.push_back(side.triangle);
    make_unique(part.faces);
    add_faces(shell, part);
    for (const Index fold : part.folds) add_fold(shell, bending, fold, part);
    return part;
}

void move_rest(ShellPart& part, const Positions& rest) {
    for (auto& [vertices, membrane] : part.shell.triangles) {
        const TrianglePositions before = columns(part.shell.rest, vertices), after = columns(rest, vertices);
        // Angle by which the side on the frame's first axis turns against the material.
        const Eigen::Matrix<double, 3, 2> axes = frame_axes(before);
        const Vector3d side = after.col(1) - after.col(0);
        const double turn = std::atan2(axes.col(1).dot(side), axes.col(0).dot(side));
        membrane = membrane_triangle(after, turned_elasticity(membrane.elasticity, -turn));
    }
    part.shell.rest = rest;
}

}  // namespace sherd
