// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/forces/edge_moment.h"
#include "core/state_visitor.h"

namespace sherd {

/// A dead force, N, on a corner of a triangle. It refers to a triangle since a crack may split the vertex.
struct CornerForce {
    Index triangle = 0;
    int corner = 0;
    Vector3d force = Vector3d::Zero();
};

/// A dead force, N, that is spread evenly over a triangle: a third of it on each corner.
struct FaceForce {
    Index triangle = 0;
    Vector3d force = Vector3d::Zero();
};

/// External forces, which grow linearly from zero at time 0 and keep their full size from time `ramp` on.
struct Load {
    std::vector<CornerForce> dead;         ///< forces of constant direction
    std::vector<Index> pressed;            ///< triangles under pressure
    std::vector<EdgeMoment> moments = {};  ///< moments on sides of triangles
    double pressure = 0;                   ///< Pa, along the normal of a triangle in its current position
    double ramp = 0;                       ///< s; 0: full size from the start
    std::vector<FaceForce> spread = {};    ///< forces of constant direction on faces

    void visit_state(StateVisitor& visit) {
        auto& [dead, pressed, moments, pressure, ramp, spread] = *this;
        visit(dead, pressed, moments, spread);
    }
};

/// Applies `force` (N) to each of the vertices. Throws std::out_of_range if a vertex has no triangle.
std::vector<CornerForce> point_forces(const Shell& shell, std::span<const Index> vertices,
                                      const Vector3d& force);
/// Distributes `force`, in N per m of rest length, over the sides.
std::vector<CornerForce> line_forces(const Shell& shell, std::span<const TriangleEdge> sides,
                                     const Vector3d& force);
/// Distributes `force`, in N per m^2 of rest area, over the triangles.
std::vector<FaceForce> area_forces(const Shell& shell, std::span<const Index> triangles,
                                   const Vector3d& force);

/// Triangles under pressure. Their energy is minus the pressure times the volume under them, the cones from
/// `centre` to the triangles.
struct PressedTriangles {
    struct Pressed {
        std::array<Index, 3> vertices;
        double pressure;  ///< Pa, in the current step
    };
    std::vector<Pressed> triangles;
    Vector3d centre = Vector3d::Zero();  ///< m, apex of the cones

    std::size_t size() const { return triangles.size(); }
    const std::array<Index, 3>& vertices(std::size_t i) const { return triangles[i].vertices; }
    double value(std::size_t i, const TrianglePositions& x) const;
    TrianglePositions gradient(std::size_t i, const TrianglePositions& x) const;
    /// The Hessian of the volume is indefinite; its convex approximation is zero.
    Eigen::Matrix<double, 9, 9> hessian(std::size_t i, const TrianglePositions& x, Curvature curvature) const;
};

/// The potential of loads in one time step: minus the work of dead forces and of moments, minus pressure
/// times the volume under the pressed triangles (the cones from their centre at the beginning of the step).
/// In the interior of the pressed surface the volume's derivative is the force of the pressure, so that
/// closed sheets, and sheets that are held along their rim, get the exact force and its symmetric tangent. At
/// a free rim the derivative differs from the force. There the difference is added as a dead force, evaluated
/// at the beginning of the step, since the load stiffness has no symmetric form.
class LoadEnergy : public Energy {
  public:
    /// The shell must outlive this object.
    LoadEnergy(const Shell& shell, std::vector<Load> loads) : shell(shell), loads(std::move(loads)) {}
    void begin(const StepContext& step) override;
    /// Inserted faces are under pressure if their first parent is. Dead forces stay on the corners of their
    /// triangles. Where triangles change, forces on corners stay with their vertices and moments with their
    /// sides; these vertices and sides must stay in their place. Forces spread over triangles are inherited
    /// by area. Throws std::runtime_error if a side with a moment no longer exists.
    void topology_changed(const ShellChange& change, const StepContext& step) override;
    double value(const Positions& x) const override;  ///< J, zero at the beginning of the step
    void add_gradient(const Positions& x, Positions& gradient) const override;
    void add_hessian(const Positions& x, Curvature curvature, BlockMatrix& hessian) const override;
    Task task() const override { return Task::loads; }
    void add_pattern(std::vector<std::pair<Index, Index>>& pairs) const override;
    void visit_state(StateVisitor& visit) override {
        auto& [shell, loads, start, force, pressed, turned, start_potential] = *this;
        visit(loads);
    }

  private:
    /// Sums the loads as they are at the end of the step.
    void sum_loads(const StepContext& step);
    /// Adds the dead force by which the volume's derivative falls short of the pressure's force.
    void complete_pressure();

    const Shell& shell;
    std::vector<Load> loads;
    Positions start;  ///< [3, V] m, positions at the beginning of the step
    Positions force;  ///< [3, V] N, dead forces
    PressedTriangles pressed;
    TurnedTriangles turned;
    double start_potential = 0;
};

}  // namespace sherd
