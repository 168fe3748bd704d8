// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
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

/// The energy of a contact at a point, with derivatives by the point's position. The opposite force acts on
/// the collider that the point touches.
struct PointForce {
    double value;       ///< J
    Vector3d gradient;  ///< N
    Matrix3d hessian;   ///< N/m
};

/// The force of a spring that resists overlap; stiffness: N/m.
inline PointForce spring(const Overlap& at, double stiffness, Curvature curvature) {
    PointForce force{0.5 * stiffness * at.depth * at.depth, -(stiffness * at.depth * at.normal),
                     stiffness * (at.normal * at.normal.transpose())};
    if (curvature == Curvature::exact) force.hessian -= stiffness * at.depth * at.curvature;
    return force;
}

/// A point that touched a collider at the beginning of the step, with its friction in the step.
struct SlidingPoint {
    Vector3d anchor;  ///< m, position of the point if it sticks, in a frame that the owner chooses
    Vector3d normal;  ///< in space, of unit length
    Friction friction;

    /// The friction force on the point at x (m); anchor: in space.
    PointForce force(const Vector3d& x, const Vector3d& anchor) const {
        const Vector3d slip = along(x - anchor);
        const Matrix3d tangent = Matrix3d::Identity() - normal * normal.transpose();
        return {friction.value(slip), friction.gradient(slip), friction.hessian(slip, tangent)};
    }
    /// Elastic slip for the next step (Friction::elastic_slip_after()) when the point is at x (m); anchor: in
    /// space.
    Vector3d elastic_slip_after(const Vector3d& x, const Vector3d& anchor) const {
        return friction.elastic_slip_after(along(x - anchor));
    }

  private:
    Vector3d along(const Vector3d& way) const { return way - normal * normal.dot(way); }
};

/// Friction of a point that overlaps a collider, with the spring's force there as normal force. turn:
/// rotation applied to the normal, whose length sampled shapes give only near one, and to the elastic slip
/// `elastic_slip` (StickMemory); length: s, of the step.
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

/// Contact of the shell's vertices with one collider, active within half the thickness. The caller gives the
/// collider's pose. The stiffness depends on the two materials, not on mesh or time step: each vertex is a
/// column of sheet whose height is the thickness, whose cross-section is the vertex's footprint and whose
/// Young's modulus is that of sheet and collider in series: k = footprint / thickness / (1/Y_sheet +
/// 1/Y_collider). The footprint is the vertex's share of the sheet's area plus, on the rim, the thickness
/// times its share of the rim: on any mesh a sheet that lands flat bears a pressure of Y d / t, and one that
/// lands on its edge a line force of Y d. Friction is Coulomb's with the normal forces of the beginning of
/// the step, on the slip along the collider plus the elastic slip of vertices that stick (a potential in the
/// displacement of the step, so that Newton's method minimises one function).
class VertexContact {
  public:
    /// Shell and collider must outlive this object. number: of the collider in shell.start_depths.
    VertexContact(const Shell& shell, const Collider& collider, std::size_t number)
        : shell(shell), collider(collider), number(number) {}

    /// Records which vertices touch the collider, whose pose is `pose`, at the beginning of the step.
    /// anchor(x): the anchor (see SlidingPoint) of a vertex at x. turn: the collider's rotation in the step,
    /// applied to normals. length: s. elastic_slip: elastic slip of vertices, in space.
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
    /// Calls add(vertex, force) for each vertex of x [3, V] that overlaps the collider.
    template <class Add>
    void add_springs(const Positions& x, const Eigen::Isometry3d& pose, Curvature curvature, Add add) const {
        const PlacedBox box(*collider.shape, pose);
        for (Index v = 0; v < static_cast<Index>(x.cols()); ++v)
            if (box.is_near(box.local(x.col(v)), reach(v)))
                if (const Overlap at = overlap(x, v, pose); at.depth > 0)
                    add(v, spring(at, stiffness(v), curvature));
    }
    /// Calls add(vertex, force, anchor) for each vertex with friction; frame: from the anchors' frame to
    /// space.
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
    /// The largest stiffness of a contact over the mass of its vertex, 1/s^2, of the vertices of x that are
    /// within `margin` (m) of the collider.
    double largest_rate(const Positions& x, const Eigen::Isometry3d& pose, double margin) const {
        double largest = 0;
        for (Index v = 0; v < static_cast<Index>(x.cols()); ++v)
            if (overlap(x, v, pose, margin).depth > 0)
                largest = std::max(largest, stiffness(v) / shell.mass[v]);
        return largest;
    }
    /// Sum of the stiffnesses, N/m, of the contacts of the vertices of x that are within `margin` (m) of the
    /// collider.
    double total_stiffness(const Positions& x, const Eigen::Isometry3d& pose, double margin) const {
        double sum = 0;
        for (Index v = 0; v < static_cast<Index>(x.cols()); ++v)
            if (overlap(x, v, pose, margin).depth > 0) sum += stiffness(v);
        return sum;
    }
    /// Overlap of a vertex with the collider beyond the exempt overlap of the start; margin: m, added to half
    /// the thickness.
    Overlap overlap(const Positions& x, Index vertex, const Eigen::Isometry3d& pose,
                    double margin = 0) const {
        return sherd::overlap(*collider.shape, pose, x.col(vertex), reach(vertex) + margin);
    }

    void visit_state(StateVisitor& visit) {
        auto& [shell, collider, number, sliding] = *this;
        visit(sliding);
    }

  private:
    struct Sliding {
        Index vertex;
        SlidingPoint point;
    };
    double reach(Index vertex) const {  ///< m
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
