// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/contact/crack_faces/crack_face.h"

#include <Eigen/Geometry>
#include <algorithm>

#include "core/contact/barrier/contact_pair.h"

namespace sherd {
namespace {

/// Orthonormal frame of the triangle: `along` the crack face, `out` of the triangle within its plane, and
/// `normal` to the plane.
struct CrackFaceFrame {
    Vector3d along, out, normal;
    double length, height;  ///< m, length of the crack face, and height of the apex above the face
    double foot;            ///< place of the apex projected on the crack face: 0 at vertex 1, 1 at vertex 2
};

CrackFaceFrame crack_face_frame(const PairPositions& x) {
    CrackFaceFrame frame;
    const Vector3d edge = x.col(2) - x.col(1), apex = x.col(3) - x.col(1);
    frame.length = edge.norm();
    frame.along = edge / frame.length;
    frame.foot = apex.dot(frame.along) / frame.length;
    const Vector3d rise = apex - apex.dot(frame.along) * frame.along;
    frame.height = rise.norm();
    frame.out = -rise / frame.height;
    frame.normal = frame.along.cross(frame.out);
    return frame;
}

}  // namespace

double crack_face_opening(const PairPositions& x) {
    return crack_face_frame(x).out.dot(x.col(0) - x.col(1));
}

PairPositions crack_face_opening_gradient(const PairPositions& x) {
    const CrackFaceFrame frame = crack_face_frame(x);
    const Vector3d gap = x.col(0) - x.col(1);
    // `turn` is due to the rotation of the crack face within the plane of the triangle, `fold` to the tilting
    // of this plane; both rotate `out`.
    const Vector3d turn = gap.dot(frame.along) / frame.length * frame.out;
    const Vector3d fold = gap.dot(frame.normal) / frame.height * frame.normal;
    PairPositions gradient;
    gradient.col(0) = frame.out;
    gradient.col(1) = -frame.out + turn + (1 - frame.foot) * fold;
    gradient.col(2) = -turn + frame.foot * fold;
    gradient.col(3) = -fold;
    return gradient;
}

PairHessian crack_face_opening_hessian(const PairPositions& x) {
    using PairVector = Eigen::Matrix<double, 12, 1>;
    const CrackFaceFrame frame = crack_face_frame(x);
    const Vector3d gap = x.col(0) - x.col(1);
    const double across = gap.dot(frame.out) / 2, along = gap.dot(frame.along), above = gap.dot(frame.normal);
    const double l = frame.length, h = frame.height;
    // Linear forms of the displacements of the four vertices. Each is the component, along one axis of the
    // frame, of a relative displacement: of vertex 0 from vertex 1 (gap), of vertex 2 from vertex 1 (edge),
    // or of the apex from its foot on the crack face (apex).
    const auto form = [](const Eigen::Vector4d& weights, const Vector3d& direction) -> PairVector {
        return (direction * weights.transpose()).reshaped();
    };
    const Eigen::Vector4d of_gap(1, -1, 0, 0), of_edge(0, -1, 1, 0),
        of_apex(0, frame.foot - 1, -frame.foot, 1);
    const PairVector edge_out = form(of_edge, frame.out), edge_normal = form(of_edge, frame.normal);
    const PairVector apex_normal = form(of_apex, frame.normal);
    const PairVector with_edge = -form(of_gap, frame.along) / l -
                                 (across * edge_out - along * form(of_edge, frame.along)) / (l * l) -
                                 above / (l * l) * edge_normal;
    const PairVector with_apex = -form(of_gap, frame.normal) / h + along / (l * h) * edge_normal -
                                 (across * apex_normal + above * form(of_apex, frame.out)) / (h * h);
    const PairHessian half = edge_out * with_edge.transpose() + apex_normal * with_apex.transpose() +
                             above / (l * h) * edge_normal * form(of_apex, frame.along).transpose();
    return half + half.transpose();
}

double value(const CrackFaceStencil& crack_face, const PairPositions& x) {
    const double overlap = std::max(0.0, -crack_face_opening(x));
    return 0.5 * crack_face.stiffness * overlap * overlap;
}

PairPositions gradient(const CrackFaceStencil& crack_face, const PairPositions& x) {
    const double opening = crack_face_opening(x);
    if (opening >= 0) return PairPositions::Zero();
    return crack_face.stiffness * opening * crack_face_opening_gradient(x);
}

PairHessian hessian(const CrackFaceStencil& crack_face, const PairPositions& x, bool convex) {
    const double opening = crack_face_opening(x);
    if (opening >= 0) return PairHessian::Zero();
    const PairPositions slope = crack_face_opening_gradient(x);
    PairHessian block = slope.reshaped() * slope.reshaped().transpose();
    if (!convex) block += opening * crack_face_opening_hessian(x);
    return crack_face.stiffness * block;
}

double CrackFaceContact::largest_overlap(const Positions& x) const {
    double largest = 0;
    for (std::size_t i = 0; i < elements.size(); ++i)
        largest = std::max(largest, -crack_face_opening(columns(x, elements.vertices(i))));
    return largest;
}

}  // namespace sherd
