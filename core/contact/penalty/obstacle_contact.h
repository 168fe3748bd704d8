// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/contact/colliders/obstacle.h"
#include "core/contact/friction/friction.h"
#include "core/energy.h"
#include "core/shell/sheet.h"

namespace sherd {

/// Contact of a sheet's vertices with an obstacle in one step, from half the thickness on.
/// The stiffness is a property of the two materials, whatever the mesh and the step: each vertex is a column
/// of sheet, as high as the sheet is thick and of the vertex's footprint in cross-section, whose Young's
/// modulus is that of the sheet and the obstacle in series:  k = footprint / thickness / (1/Y_sheet +
/// 1/Y_obstacle). The footprint is the vertex's share of the sheet's area, plus, on the rim, thickness times
/// its share of the rim: a sheet that lands flat feels a pressure of Y d / t, one that lands on its edge a
/// line force of Y d, on any mesh. The obstacle stands where it is at the end of the step. Friction is
/// Coulomb's with the normal forces of the beginning of the step, on the way slid along the obstacle,
/// smoothed below a sliding speed of 1 cm/s (a potential in the displacement of the step, so that Newton's
/// method sees one function).
class ObstacleContact : public Energy {
  public:
    /// Sheet and obstacle must outlive it.
    ObstacleContact(const Sheet& sheet, const Obstacle& obstacle) : sheet(sheet), obstacle(obstacle) {}
    void begin(const StepContext& step) override;
    double value(const Positions& x) const override;  ///< with the friction potential
    void add_gradient(const Positions& x, Positions& gradient) const override;
    void add_hessian(const Positions& x, Curvature curvature, BlockMatrix& hessian) const override;
    Task task() const override { return Task::contact; }
    void add_pattern(std::vector<std::pair<Index, Index>>&) const override {}

    /// Elastic energy stored in the contacts, J.
    double stored_energy(const Positions& x) const;
    void add_touch(const Positions& x, Touch& touch) const;

  private:
    /// A vertex that touched at the beginning of the step.
    struct Sliding {
        Index vertex;
        Vector3d stuck;  ///< m, where it would be had it stuck to the obstacle
        Vector3d normal;
        Friction friction;
        Vector3d slip(const Positions& x) const;  ///< m
    };

    double stiffness(Eigen::Index vertex) const;  ///< N/m
    Overlap overlap(const Positions& x, Eigen::Index vertex, const Eigen::Isometry3d& pose) const;
    void find_sliding(const StepContext& step);

    const Sheet& sheet;
    const Obstacle& obstacle;
    Eigen::Isometry3d pose;  ///< at the end of the step
    std::vector<Sliding> sliding;
};

}  // namespace sherd
