// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mirror_hinge.h"

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

}  // namespace

MirrorHinge clamp_hinge(const Sheet& sheet, const TriangleSide& side, double stiffness) {
    const TrianglePositions x = triangle_positions(sheet.rest, side_vertices(sheet, side));
    const Vector3d along = (x.col(1) - x.col(0)).normalized(), across = x.col(2) - x.col(0);
    MirrorHinge hinge =
        symmetry_hinge(sheet, side, (across - along * along.dot(across)).normalized(), stiffness);
    hinge.carrier = sheet.carrier[side_vertices(sheet, side)[0]];
    return hinge;
}

MirrorHinge symmetry_hinge(const Sheet& sheet, const TriangleSide& side, const Vector3d& normal,
                           double stiffness) {
    const TrianglePositions x = triangle_positions(sheet.rest, side_vertices(sheet, side));
    const double offset = normal.dot(Vector3d(x.col(0)));
    return {side, normal, offset, cubic_hinge(with_image(x, normal, offset), stiffness)};
}

MirrorHinge moved(MirrorHinge hinge, const Eigen::Isometry3d& pose) {
    const Vector3d point = pose * Vector3d(hinge.offset * hinge.normal);
    hinge.normal = pose.linear() * hinge.normal;
    hinge.offset = hinge.normal.dot(point);
    return hinge;
}

HingePositions MirrorEnergy::mirrored(const MirrorHinge& hinge, const Positions& x) const {
    return with_image(triangle_positions(x, side_vertices(sheet, hinge.side)), hinge.normal, hinge.offset);
}

double MirrorEnergy::value(const Positions& x) const {
    double sum = 0;
    for (const MirrorHinge& hinge : hinges) sum += 0.5 * sherd::value(hinge.bending, mirrored(hinge, x));
    return sum;
}

void MirrorEnergy::add_gradient(const Positions& x, Positions& gradient) const {
    for (const MirrorHinge& hinge : hinges) {
        const HingePositions local = 0.5 * sherd::gradient(hinge.bending, mirrored(hinge, x));
        const std::array<Index, 3> vertices = side_vertices(sheet, hinge.side);
        for (int i = 0; i < 3; ++i) gradient.col(vertices[i]) += local.col(i);
        gradient.col(vertices[2]) += reflection(hinge) * local.col(3);
    }
}

void MirrorEnergy::add_hessian(const Positions& x, Curvature curvature, BlockMatrix& hessian) const {
    for (const MirrorHinge& hinge : hinges) {
        Eigen::Matrix<double, 12, 9> image = Eigen::Matrix<double, 12, 9>::Identity();
        image.block<3, 3>(9, 6) = reflection(hinge);
        const Eigen::Matrix<double, 12, 12> full =
            sherd::hessian(hinge.bending, mirrored(hinge, x), curvature == Curvature::exact);
        const Eigen::Matrix<double, 9, 9> local = 0.5 * image.transpose() * full * image;
        add_element(hessian, side_vertices(sheet, hinge.side), local);
    }
}

void MirrorEnergy::add_pattern(std::vector<std::pair<Index, Index>>& pairs) const {
    for (const MirrorHinge& hinge : hinges) add_pairs(pairs, side_vertices(sheet, hinge.side));
}

}  // namespace sherd
