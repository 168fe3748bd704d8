// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/element_energy.h"
#include "core/shell/sides.h"

namespace sherd {

/// A dead force, N, on a corner of a triangle: of a triangle, because a crack splits vertices.
struct CornerForce {
    Index triangle = 0;
    int corner = 0;
    Vector3d force = Vector3d::Zero();
};

/// Forces from outside, which grow linearly from zero at time 0 and stay at their full size from `ramp` on.
struct Load {
    std::vector<CornerForce> dead;  ///< keep their direction
    std::vector<Index> pressed;     ///< triangles under pressure
    double pressure = 0;            ///< Pa, along the triangle's normal in its current position
    double ramp = 0;                ///< s; 0: full from the start
};

/// `force` (N) on each of the vertices. Throws std::out_of_range on one that no triangle has.
std::vector<CornerForce> point_forces(const Sheet& sheet, std::span<const Index> vertices,
                                      const Vector3d& force);
/// `force` in N per m of rest length of each side.
std::vector<CornerForce> line_forces(const Sheet& sheet, std::span<const TriangleSide> sides,
                                     const Vector3d& force);
/// `force` in N per m^2 of rest area of each triangle.
std::vector<CornerForce> area_forces(const Sheet& sheet, std::span<const Index> triangles,
                                     const Vector3d& force);

/// Triangles under pressure, whose energy is minus pressure times the volume under them.
struct PressedTriangles {
    struct Pressed {
        std::array<Index, 3> vertices;
        double pressure;  ///< Pa, now
    };
    std::vector<Pressed> triangles;
    Vector3d centre = Vector3d::Zero();  ///< m, from where the volume is seen

    std::size_t size() const { return triangles.size(); }
    const std::array<Index, 3>& vertices(std::size_t i) const { return triangles[i].vertices; }
    double value(std::size_t i, const TrianglePositions& x) const;
    TrianglePositions gradient(std::size_t i, const TrianglePositions& x) const;
    /// The volume's second derivative is indefinite: it has no convex part worth keeping.
    Eigen::Matrix<double, 9, 9> hessian(std::size_t i, const TrianglePositions& x, Curvature curvature) const;
};

/// The potential of loads in one time step: minus the work of the dead forces, minus pressure times the
/// volume under the pressed triangles (as seen from their centre at the beginning of the step). Wherever the
/// pressed surface goes on all around, the volume's derivative is the pressure's force, so that closed sheets
/// and those that are held along their rim have the exact force and its symmetric tangent. At a free rim what
/// the volume misses is added as the dead force that it was at the beginning of the step: there the load
/// stiffness has no symmetric form.
class LoadEnergy : public Energy {
  public:
    /// The shell must outlive it.
    LoadEnergy(const Sheet& sheet, std::vector<Load> loads) : sheet(sheet), loads(std::move(loads)) {}
    void begin(const StepContext& step) override;
    double value(const Positions& x) const override;  ///< zero at the beginning of the step
    void add_gradient(const Positions& x, Positions& gradient) const override;
    void add_hessian(const Positions& x, Curvature curvature, BlockMatrix& hessian) const override;
    Task task() const override { return Task::loads; }
    void add_pattern(std::vector<std::pair<Index, Index>>& pairs) const override;

  private:
    /// Takes what the loads are at `time` (s).
    void sum_loads(double time);
    /// Adds the dead force that the volume under the pressed triangles misses.
    void complete_pressure();

    const Sheet& sheet;
    std::vector<Load> loads;
    Positions start;  ///< [3, V] m
    Positions force;  ///< [3, V] N, dead
    PressedTriangles pressed;
    double start_potential = 0;
};

}  // namespace sherd
