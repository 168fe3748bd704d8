// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/elements/hinge.h"

namespace sherd {

/// The dihedral angle of a hinge (hinge_angle()) with its derivatives, on any deformation; NaN where a
/// triangle has no area. No trigonometric function is evaluated.
class DihedralAngle {
  public:
    /// x: m.
    explicit DihedralAngle(const HingePositions& x) : flaps{flap(x, 2), flap(x, 3)} {}
    /// cos and sin of the angle.
    Vector2d turn() const;
    /// d(theta)/dx, 1/m, [3, 4].
    HingePositions gradient() const;
    /// Adds factor d2(theta)/dx2, [12, 12], coordinate fastest.
    void add_hessian(double factor, HingeHessian& hessian) const;

  private:
    /// A triangle (x0, x1, apex) of the hinge, with the orthonormal frame of the common edge. Displacements
    /// dx of its vertices move the apex by sum_i from_foot[i] dx_i relative to the material point of the edge
    /// below it.
    struct Flap {
        Vector3d along;      ///< unit vector of the edge
        Vector3d across;     ///< unit vector in the triangle, from the edge to the apex
        Vector3d normal;     ///< along x across
        Vector3d from_foot;  ///< weights of x0, x1, apex
        double length;       ///< m, of the edge
        double height;       ///< m, of the apex over the edge
    };
    static Flap flap(const HingePositions& x, int apex);

    std::array<Flap, 2> flaps;
};

}  // namespace sherd
