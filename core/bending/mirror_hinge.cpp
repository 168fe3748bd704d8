// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/bending/mirror_hinge.h"

#include <numeric>

namespace sherd {
namespace {

HingePositions with_image(const TrianglePositions& x, const Vector3d& normal, double offset) {
    const Vector3d apex = x.col(2);
    HingePositions local;
    local << x, apex - 2 * (normal.dot(apex) - offset) * normal;
    return local;
}

/// The hinge with its plane moved by `pose`.
MirrorHinge moved(MirrorHinge hinge, const Eigen::Isometry3d& pose) {
    const Vector3d point = pose * Vector3d(hinge.offset * hinge.normal);
    hinge.normal = pose.linear() * hinge.normal;
    hinge.offset = hinge.normal.dot(point);
    return hinge;
}

}  // namespace

MirrorHinge clamp_hinge(const Shell& shell, const TriangleEdge& side, double stiffness) {
    const TrianglePositions x = columns(shell.rest, edge_and_apex(shell, side));
    const Vector3d along = (x.col(1) - x.col(0)).normalized(), across = x.col(2) - x.col(0);
    MirrorHinge hinge =
        symmetry_hinge(shell, side, (across - along * along.dot(across)).normalized(), stiffness);
    hinge.script = shell.script[edge_and_apex(shell, side)[0]];
    return hinge;
}

MirrorHinge symmetry_hinge(const Shell& shell, const TriangleEdge& side, const Vector3d& normal,
                           double stiffness) {
    const TrianglePositions x = columns(shell.rest, edge_and_apex(shell, side));
    const double offset = normal.dot(Vector3d(x.col(0)));
    return {side, normal, offset, stiffness};
}

Mirrors::Mirrors(const Shell& shell, std::vector<MirrorHinge> hinges)
    : shell(shell), at_rest(std::move(hinges)), hinges(at_rest), origins(at_rest.size()) {
    std::iota(origins.begin(), origins.end(), 0);
}

void Mirrors::follow(const ShellChange& change) {
    for (std::size_t i = 0, count = hinges.size(); i < count; ++i) {
        const std::vector<TriangleEdge> sides = sides_after(shell, change, hinges[i].side);
        at_rest[i].side = hinges[i].side = sides.front();
        if (sides.size() == 1) continue;
        for (std::vector<MirrorHinge>* list : {&at_rest, &hinges}) {
            MirrorHinge second = (*list)[i];
            second.side = sides.back();
            list->push_back(second);
        }
        origins.push_back(origins[i]);
    }
}

void Mirrors::begin(const StepContext& step) {
    for (std::size_t i = 0; i < hinges.size(); ++i)
        if (const Index script = hinges[i].script; script != 0)
            hinges[i] = moved(at_rest[i], shell.motions[script - 1].at(step.end()));
}

HingePositions Mirrors::with_image(std::size_t i, const Positions& x) const {
    return sherd::with_image(columns(x, vertices(i)), hinges[i].normal, hinges[i].offset);
}

HingePositions Mirrors::rest(std::size_t i) const {
    const TrianglePositions triangle = columns(shell.rest, vertices(i));
    const Vector3d& normal = at_rest[i].normal;
    return sherd::with_image(triangle, normal, normal.dot(Vector3d(triangle.col(0))));
}

Matrix3d Mirrors::reflection(std::size_t i) const {
    return Matrix3d::Identity() - 2 * hinges[i].normal * hinges[i].normal.transpose();
}

Eigen::Matrix<double, 9, 9> Mirrors::folded(std::size_t i, const HingeHessian& hessian) const {
    Eigen::Matrix<double, 12, 9> image = Eigen::Matrix<double, 12, 9>::Identity();
    image.block<3, 3>(9, 6) = reflection(i);
    return image.transpose() * hessian * image;
}

MirrorEnergy::MirrorEnergy(const Shell& shell, std::vector<MirrorHinge> hinges)
    : mirrors(shell, std::move(hinges)) {
    find_bending();
}

void MirrorEnergy::topology_changed(const ShellChange& change, const StepContext& step) {
    mirrors.follow(change);
    if (!change.reshaped.empty()) find_bending();
    begin(step);
}

void MirrorEnergy::find_bending() {
    bending.clear();
    for (std::size_t i = 0; i < mirrors.size(); ++i)
        bending.push_back(cubic_hinge(mirrors.rest(i), mirrors[i].stiffness));
}

double MirrorEnergy::value(const Positions& x) const {
    double sum = 0;
    for (std::size_t i = 0; i < mirrors.size(); ++i)
        sum += 0.5 * sherd::value(bending[i], mirrors.with_image(i, x));
    return sum;
}

std::vector<MirrorGradient> MirrorEnergy::gradients(const Positions& x) const {
    std::vector<MirrorGradient> all;
    for (std::size_t i = 0; i < mirrors.size(); ++i) {
        const auto [from, to, apex] = mirrors.vertices(i);
        HingePositions local = 0.5 * sherd::gradient(bending[i], mirrors.with_image(i, x));
        local.col(3) = mirrors.reflection(i) * local.col(3).eval();
        all.push_back({{from, to, apex, apex}, local});
    }
    return all;
}

void MirrorEnergy::add_gradient(const Positions& x, Positions& gradient) const {
    for (const auto& [vertices, local] : gradients(x))
        for (int v = 0; v < 4; ++v) gradient.col(vertices[v]) += local.col(v);
}

void MirrorEnergy::add_hessian(const Positions& x, Curvature curvature, BlockMatrix& hessian) const {
    for (std::size_t i = 0; i < mirrors.size(); ++i) {
        const HingeHessian full =
            sherd::hessian(bending[i], mirrors.with_image(i, x), curvature == Curvature::exact);
        const Eigen::Matrix<double, 9, 9> local = 0.5 * mirrors.folded(i, full);
        add_element(hessian, mirrors.vertices(i), local);
    }
}

void MirrorEnergy::add_pattern(std::vector<std::pair<Index, Index>>& pairs) const {
    for (std::size_t i = 0; i < mirrors.size(); ++i) add_pairs(pairs, mirrors.vertices(i));
}

}  // namespace sherd
