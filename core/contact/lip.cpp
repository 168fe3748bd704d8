// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/contact/lip.h"

#include <Eigen/Geometry>
#include <algorithm>

#include "core/contact/contact_pair.h"

namespace sherd {
namespace {

/// The triangle's frame: along the lip, out of the triangle in its plane, and normal to both.
struct LipFrame {
    Vector3d along, out, normal;
    double length, height;  ///< m, of the lip, and of the triangle on it
    double foot;            ///< of the apex on the lip: 0 at its start, 1 at its end
};

LipFrame lip_frame(const PairPositions& x) {
    LipFrame frame;
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

double lip_opening(const PairPositions& x) {
    return lip_frame(x).out.dot(x.col(0) - x.col(1));
}

PairPositions lip_opening_gradient(const PairPositions& x) {
    const LipFrame frame = lip_frame(x);
    const Vector3d gap = x.col(0) - x.col(1);
    // `out` turns in the plane with the lip, and out of the plane when the apex leaves it.
    const Vector3d turn = gap.dot(frame.along) / frame.length * frame.out;
    const Vector3d fold = gap.dot(frame.normal) / frame.height * frame.normal;
    PairPositions gradient;
    gradient.col(0) = frame.out;
    gradient.col(1) = -frame.out + turn + (1 - frame.foot) * fold;
    gradient.col(2) = -turn + frame.foot * fold;
    gradient.col(3) = -fold;
    return gradient;
}

double LipContact::value(const Positions& x) const {
    double sum = 0;
    for (const LipStencil& lip : lips) {
        const double overlap = std::max(0.0, -lip_opening(pair_positions(x, lip.vertices)));
        sum += 0.5 * lip.stiffness * overlap * overlap;
    }
    return sum;
}

void LipContact::add_gradient(const Positions& x, Positions& gradient) const {
    for (const LipStencil& lip : lips) {
        const PairPositions local = pair_positions(x, lip.vertices);
        const double opening = lip_opening(local);
        if (opening >= 0) continue;
        const PairPositions force = lip.stiffness * opening * lip_opening_gradient(local);
        for (int i = 0; i < 4; ++i) gradient.col(lip.vertices[i]) += force.col(i);
    }
}

void LipContact::add_hessian(const Positions& x, Curvature, BlockMatrix& hessian) const {
    for (const LipStencil& lip : lips) {
        const PairPositions local = pair_positions(x, lip.vertices);
        if (lip_opening(local) >= 0) continue;
        const PairPositions slope = lip_opening_gradient(local);
        const PairHessian block = lip.stiffness * slope.reshaped() * slope.reshaped().transpose();
        add_element(hessian, lip.vertices, block);
    }
}

void LipContact::add_pattern(std::vector<std::pair<Index, Index>>& pairs) const {
    for (const LipStencil& lip : lips) add_pairs(pairs, lip.vertices);
}

double LipContact::largest_overlap(const Positions& x) const {
    double largest = 0;
    for (const LipStencil& lip : lips)
        largest = std::max(largest, -lip_opening(pair_positions(x, lip.vertices)));
    return largest;
}

}  // namespace sherd
