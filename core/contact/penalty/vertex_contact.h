// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "core/contact/colliders/collider.h"
#include "core/contact/colliders/placed_box.h"
#include "core/contact/colliders/start_depth.h"
#include "core/contact/colliders/touch.h"
#include "core/contact/friction/friction.h"
#include "core/contact/friction/stick_memory.h"
#include "core/energy.h"
#include "core/shell/shell.h"
#include "core/state_visitor.h"

namespace sherd {

/// The energy of a contact at a point, with its derivatives by the point's position. The force on the point
/// is the negative gradient; the opposite force acts on the collider that the point touches.
struct PointForce {
    double value;       ///< J
    Vector3d gradient;  ///< N
    Matrix3d hessian;   ///< N/m
};

/// Returns the energy of a spring that resists the overlap `at`; stiffness: N/m.
inline PointForce spring(const Overlap& at, double stiffness, Curvature curvature) {
    PointForce force{0.5 * stiffness * at.depth * at.depth, -(stiffness * at.depth * at.normal),
                     stiffness * (at.normal * at.normal.transpose())};
    if (curvature == Curvature::exact) force.hessian -= stiffness * at.depth * at.curvature;
    return force;
}

/// A point that touched a collider at the beginning of the step, with its friction in the step.
struct SlidingPoint {
    Vector3d anchor;  ///< m, position of the point if it sticks to the collider, in a frame that the caller
                      ///< of sliding_point() chooses
    Vector3d normal;  ///< in space, of unit length
    Friction friction;

    /// Returns the friction potential of the point at x (m, in space). anchor: m, the anchor in space.
    PointForce force(const Vector3d& x, const Vector3d& anchor) const {
        const Vector3d slip = along(x - anchor);
        const Matrix3d tangent = Matrix3d::Identity() - normal * normal.transpose();
        return {friction.value(slip), friction.gradient(slip), friction.hessian(slip, tangent)};
    }
    /// Returns the elastic slip for the next step (see Friction::elastic_slip_after()) of the point that ends
    /// the step at x (m, in space). anchor: m, the anchor in space.
    Vector3d elastic_slip_after(const Vector3d& x, const Vector3d& anchor) const {
        return friction.elastic_slip_after(along(x - anchor));
    }

  private:
    Vector3d along(const Vector3d& way) const { return way - normal * normal.dot(way); }
};

/// Returns the friction of a point that has the overlap `at` with a collider; the normal force is the force
/// of its spring. stiffness: N/m, of the spring; coefficient: Coulomb coefficient; length: s, of the step.
/// turn: rotation applied to the normal and to `elastic_slip` (see StickMemory). The length of the normal in
/// `at` may differ from one, since the distance of a sampled shape is approximate.
inline SlidingPoint sliding_point(const Vector3d& anchor, const Overlap& at, const Matrix3d& turn,
                                  double coefficient, double stiffness, double length,
                                  const Vector3d& elastic_slip) {
    const double norm = at.normal.norm(), smoothing = smoothing_speed * length;
    const Vector3d normal = norm > 0 ? Vector3d(turn * at.normal / norm) : at.normal;
    const Vector3d turned = turn * elastic_slip;
    return {anchor,
            normal,
            {coefficient * stiffness * at.depth * norm, smoothing,
             smoothing * (turned - normal * normal.dot(turned))}};
}

/// Contact of the shell's vertices with one collider. A vertex is in contact when its distance from the
/// collider's shape is less than half the thickness. The caller gives the collider's pose. The stiffness
/// depends on the two materials, not on mesh or time step: each vertex is a column of sheet, with the
/// thickness as height and the vertex's footprint as cross-section, of the two materials in series: k =
/// footprint / thickness / (1/Y_sheet + 1/Y_collider). The footprint is the vertex's share of the sheet's
/// area plus, on the rim, the thickness times its share of the rim. So on any mesh, for an overlap d,
/// thickness t and the modulus Y in series, a sheet that lies flat on the collider bears a pressure of Y d /
/// t, and a sheet that stands on its edge bears a line force of Y d. Friction is Coulomb's, with the normal
/// forces at the beginning of the step. It acts on the slip along the collider in the step plus the elastic
/// slip from earlier steps, and is a potential of the displacement in the step, so that Newton's method
/// minimises one function.
class VertexContact {
  public:
    /// Shell and collider must outlive this object. number: the collider's number in Shell::start_depths.
    VertexContact(const Shell& shell, const Collider& collider, std::size_t number)
        : shell(shell), collider(collider), number(number) {}

    /// Finds the vertices that touch the collider at the beginning of the step, and their friction. pose: the
    /// collider's pose there; turn: its rotation in the step, applied to normals; length: s, of the step.
    /// elastic_slip: elastic slip of vertices at the end of the last step, in space. anchor(x): returns the
    /// anchor (see SlidingPoint) of a vertex at x.
    template <class Anchor>
    void begin(const Eigen::Isometry3d& pose, const Matrix3d& turn, double length,
               const StickMemory<Index>& elastic_slip, Anchor anchor) {
        sliding.clear();
        if (collider.friction == 0) return;
        for (Index v = 0; v < static_cast<Index>(shell.position.cols()); ++v) {
            const Overlap at = overlap(shell.position, v, pose);
            if (at.depth <= 0) continue;
            sliding.push_back(
                {v, sliding_point(anchor(Vector3d(shell.position.col(v))), at, turn, collider.friction,
                                  stiffness(v), length, elastic_slip.slip_of(v))});
        }
    }
    /// Calls add(vertex, force) for each vertex that overlaps the collider, with the vertices at x, [3, V] m;
    /// force: a PointForce.
    template <class Add>
    void add_springs(const Positions& x, const Eigen::Isometry3d& pose, Curvature curvature, Add add) const {
        const PlacedBox box(*collider.shape, pose);
        for (Index v = 0; v < static_cast<Index>(x.cols()); ++v) add_spring(box, v, x, pose, curvature, add);
    }
    /// Variant for `some` vertices alone.
    template <class Add>
    void add_springs(std::span<const Index> some, const Positions& x, const Eigen::Isometry3d& pose,
                     Curvature curvature, Add add) const {
        const PlacedBox box(*collider.shape, pose);
        for (const Index v : some) add_spring(box, v, x, pose, curvature, add);
    }
    /// Calls add(vertex, force, anchor) for each vertex with friction, with the vertices at x, [3, V] m.
    /// force: a PointForce; anchor: m, in space. frame: transforms the anchors' frame to space.
    template <class Add>
    void add_friction(const Positions& x, const Eigen::Isometry3d& frame, Add add) const {
        for (const auto& [vertex, point] : sliding) {
            const Vector3d anchor = frame * point.anchor;
            add(vertex, point.force(x.col(vertex), anchor), anchor);
        }
    }
    /// Stores the elastic slip of vertices after the step that ends at x; frame: see add_friction().
    void store_slip(const Positions& x, const Eigen::Isometry3d& frame,
                    StickMemory<Index>& elastic_slip) const {
        elastic_slip.clear();
        for (const auto& [vertex, point] : sliding)
            elastic_slip.keep(vertex, point.elastic_slip_after(x.col(vertex), frame * point.anchor));
    }
    void add_touch(const Positions& x, const Eigen::Isometry3d& pose, Touch& touch) const {
        for (Index v = 0; v < static_cast<Index>(x.cols()); ++v) touch.include(v, overlap(x, v, pose).depth);
    }
    /// Calls visit(vertex, rate) for the vertices that touch the collider if half their thickness is enlarged
    /// by `margin` (m); rate: 1/s^2, ratio of a contact's stiffness to its vertex's mass. x: [3, V] m.
    template <class Visit>
    void each_rate(const Positions& x, const Eigen::Isometry3d& pose, double margin, Visit visit) const {
        for (Index v = 0; v < static_cast<Index>(x.cols()); ++v)
            if (overlap(x, v, pose, margin).depth > 0) visit(v, stiffness(v) / shell.mass[v]);
    }
    /// Sum of the stiffnesses, N/m, of the contacts of the vertices that touch the collider if half their
    /// thickness is enlarged by `margin` (m). x: [3, V] m.
    double total_stiffness(const Positions& x, const Eigen::Isometry3d& pose, double margin) const {
        double sum = 0;
        for (Index v = 0; v < static_cast<Index>(x.cols()); ++v)
            if (overlap(x, v, pose, margin).depth > 0) sum += stiffness(v);
        return sum;
    }
    /// Overlap of a vertex with the collider, less its exempt overlap (see start_depth()). margin: m, added
    /// to half the thickness.
    Overlap overlap(const Positions& x, Index vertex, const Eigen::Isometry3d& pose,
                    double margin = 0) const {
        return sherd::overlap(*collider.shape, pose, x.col(vertex), reach(vertex) + margin);
    }

    void visit_state(StateVisitor& visit) {
        auto& [shell, collider, number, sliding] = *this;
        visit(sliding);
    }

  private:
    template <class Add>
    void add_spring(const PlacedBox& box, Index v, const Positions& x, const Eigen::Isometry3d& pose,
                    Curvature curvature, Add add) const {
        if (!box.is_near(box.local(x.col(v)), reach(v))) return;
        if (const Overlap at = overlap(x, v, pose); at.depth > 0) add(v, spring(at, stiffness(v), curvature));
    }
    struct Sliding {
        Index vertex;
        SlidingPoint point;
    };
    double reach(Index vertex) const {  ///< m, contact radius: half the thickness less the exempt overlap
        return 0.5 * shell.thickness[vertex] - start_depth(shell, number, vertex);
    }
    double stiffness(Index vertex) const {  ///< N/m
        return column_stiffness(shell.footprint[vertex], shell.thickness[vertex], shell.young[vertex],
                                collider.young);
    }

    const Shell& shell;
    const Collider& collider;
    std::size_t number;
    std::vector<Sliding> sliding;
};

}  // namespace sherd
