// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/energy.h"
#include "core/sheet.h"

namespace sherd {

/// A fixed plane; what is behind it is solid.
struct Plane {
    Vector3d point = Vector3d::Zero();    ///< m
    Vector3d normal = Vector3d::UnitZ();  ///< unit length, towards the free side
    double young = 3e10;                  ///< Pa, of what the plane is made of
    double friction = 0;                  ///< Coulomb coefficient
};

/// Contact of a sheet's vertices with a plane, from half the thickness on.
/// The stiffness is a property of the two materials, whatever the mesh and the step: each vertex is a column
/// of sheet, as high as the sheet is thick and of the vertex's footprint in cross-section, whose Young's
/// modulus is that of the sheet and the plane in series:  k = footprint / thickness / (1/Y_sheet +
/// 1/Y_plane). The footprint is the vertex's share of the sheet's area, plus, on the rim, thickness times its
/// share of the rim: a sheet that lands flat feels a pressure of Y d / t, one that lands on its edge a line
/// force of Y d, on any mesh. Friction is Coulomb's with the normal forces of the beginning of the step,
/// smoothed below a sliding speed of 1 cm/s (a potential in the displacement of the step, so that Newton's
/// method sees one function).
class PlaneContact : public Energy {
  public:
    /// sheet.position are the positions at the beginning of the step; step: s.
    PlaneContact(const Sheet& sheet, const Plane& plane, double step);
    double value(const Positions& x) const override;  ///< with the friction potential
    void add_gradient(const Positions& x, Positions& gradient) const override;
    void add_hessian(const Positions& x, Curvature curvature, BlockMatrix& hessian) const override;
    void add_pattern(std::vector<std::pair<Index, Index>>&) const override {}

    /// Elastic energy stored in the contacts, J.
    double stored_energy(const Positions& x) const;
    /// Vertices that touch.
    Index contacts(const Positions& x) const;

  private:
    double stiffness(Eigen::Index vertex) const;                   ///< N/m
    double overlap(const Vector3d& x, Eigen::Index vertex) const;  ///< m, positive when touching
    double sliding_limit(Eigen::Index vertex) const;               ///< N, friction times lagged normal force
    Vector3d sliding(const Positions& x, Eigen::Index vertex) const;  ///< m, in the plane, in this step

    const Sheet& sheet;
    Plane plane;
    double smoothing;  ///< m
};

}  // namespace sherd
