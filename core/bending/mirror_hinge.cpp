// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/bending/mirror_hinge.h"

namespace sherd {
namespace {

Matrix3d reflection(const MirrorHinge& hinge) {
    return Matrix3d::Identity() - 2 * hinge.normal * hinge.normal.transpose();
}

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

MirrorEnergy::MirrorEnergy(const Shell& shell, std::vector<MirrorHinge> mirrors)
    : shell(shell), at_rest(std::move(mirrors)), hinges(at_rest) {
    for (const MirrorHinge& hinge : hinges) {
        const TrianglePositions rest = columns(shell.rest, edge_and_apex(shell, hinge.side));
        const double offset = hinge.normal.dot(Vector3d(rest.col(0)));
        bending.push_back(cubic_hinge(with_image(rest, hinge.normal, offset), hinge.stiffness));
    }
}

void MirrorEnergy::begin(const StepContext& step) {
    for (std::size_t i = 0; i < hinges.size(); ++i)
        if (const Index script = hinges[i].script; script != 0)
            hinges[i] = moved(at_rest[i], shell.motions[script - 1].at(step.end()));
}

HingePositions MirrorEnergy::mirrored(const MirrorHinge& hinge, const Positions& x) const {
    return with_image(columns(x, edge_and_apex(shell, hinge.side)), hinge.normal, hinge.offset);
}

double MirrorEnergy::value(const Positions& x) const {
    double sum = 0;
    for (std::size_t i = 0; i < hinges.size(); ++i)
        sum += 0.5 * sherd::value(bending[i], mirrored(hinges[i], x));
    return sum;
}

void MirrorEnergy::add_gradient(const Positions& x, Positions& gradient) const {
    for (std::size_t i = 0; i < hinges.size(); ++i) {
        const HingePositions local = 0.5 * sherd::gradient(bending[i], mirrored(hinges[i], x));
        const std::array<Index, 3> vertices = edge_and_apex(shell, hinges[i].side);
        for (int v = 0; v < 3; ++v) gradient.col(vertices[v]) += local.col(v);
        gradient.col(vertices[2]) += reflection(hinges[i]) * local.col(3);
    }
}

void MirrorEnergy::add_hessian(const Positions& x, Curvature curvature, BlockMatrix& hessian) const {
    for (std::size_t i = 0; i < hinges.size(); ++i) {
        Eigen::Matrix<double, 12, 9> image = Eigen::Matrix<double, 12, 9>::Identity();
        image.block<3, 3>(9, 6) = reflection(hinges[i]);
        const Eigen::Matrix<double, 12, 12> full =
            sherd::hessian(bending[i], mirrored(hinges[i], x), curvature == Curvature::exact);
        const Eigen::Matrix<double, 9, 9> local = 0.5 * image.transpose() * full * image;
        add_element(hessian, edge_and_apex(shell, hinges[i].side), local);
    }
}

void MirrorEnergy::add_pattern(std::vector<std::pair<Index, Index>>& pairs) const {
    for (const MirrorHinge& hinge : hinges) add_pairs(pairs, edge_and_apex(shell, hinge.side));
}

}  // namespace sherd
