// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "core/membrane/membrane.h"
#include "core/tips/bending_shift.h"

namespace sherd {

/// The configurational force on the tip of a crack and its rings: the energy released for each metre of
/// advance, N, along the tip's direction and to its left. It is minus the derivative of the elastic energy by
/// the rest positions of these vertices (Eshelby, The force on an elastic singularity, 1951), while their
/// displacements, measured in a frame that turns with the sheet at the tip, are kept.
struct ConfigurationalForce {
    Vector2d membrane = Vector2d::Zero();  ///< N, part of the membrane
    Vector2d bending = Vector2d::Zero();   ///< N, part of bending
    /// Part of loads and inertia on the rings, N.
    Vector2d loads = Vector2d::Zero();
    int rings = 0;  ///< number of rings that moved with the tip

    Vector2d sum() const { return membrane + bending + loads; }
    /// Returns the sum. If no rings have moved with the tip, the membrane's part is divided by 0.91 and the
    /// part of bending by 0.96: without rings only these shares of the exact force result.
    Vector2d corrected() const;
    /// Energy release, J/m, to be compared with the fracture energy G_c times the thickness: the length of
    /// corrected(), which is right on zigzag paths, too. On a straight path the first component of
    /// corrected() is the release by straight propagation.
    double released() const { return corrected().norm(); }
};

/// The elastic energies of the sheet.
struct TipEnergies {
    const CoupledBending* bending = nullptr;  ///< null: bending has no part in the force
    MembraneModel membrane = MembraneModel::constant_strain;
};

/// Forces on the vertices other than elastic forces, N, [3, V]; without columns: no such forces.
struct TipLoads {
    Positions spread = Positions(3, 0);  ///< on faces: pressure, weight and wind, less mass times
                                         ///< acceleration
    Positions on_crack_faces =
        Positions(3, 0);  ///< on crack faces: contact between them, and cohesive forces
};

/// Computes the configurational force on a tip. Terms that depend on the rest shape alone are computed once:
/// the object must be replaced when the tip, its rings or hinges within four edges of them have changed.
class TipForce {
  public:
    /// Shell, around and bending must outlive this object. Throws std::invalid_argument for a membrane of
    /// arcs, whose energy depends on the rest shape in other ways, too.
    TipForce(const Shell& shell, const VertexFaces& around, const TipEnergies& energies, const CrackTip& tip,
             int most_rings = 2);

    /// Returns the force at x, [3, V] m, which must be a solution under these loads.
    ConfigurationalForce at(const Positions& x, const TipLoads& loads = {}) const;

  private:
    Vector2d of_membrane(const Positions& x, const Matrix3d& turn) const;
    Vector2d of_spread(const Positions& x, const Positions& forces, const Matrix3d& turn) const;
    Vector2d of_crack_faces(const Positions& x, const Positions& forces, const Matrix3d& turn) const;

    const Shell& shell;
    const VertexFaces& around;
    std::array<std::vector<Index>, 2> crack_faces;  ///< vertices of both crack faces, from the tip itself on
    TipShift shift;
    std::vector<Index> faces;  ///< faces with a vertex that moves
    int rings;
    std::optional<BendingShift> bending;
};

}  // namespace sherd
