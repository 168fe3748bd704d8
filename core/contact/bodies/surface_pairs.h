// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <span>

#include "core/contact/bodies/body_step.h"
#include "core/contact/colliders/obstacle.h"
#include "core/contact/detection/box_tree.h"
#include "core/state_visitor.h"

namespace sherd {

/// The surface of a collider with which a body collides, in the collider's frame. A deforming surface has two
/// shapes, at the beginning and at the end of a step or a substep.
class OtherSurface {
  public:
    explicit OtherSurface(const Collider& collider);
    /// Surface of an obstacle, which may deform.
    explicit OtherSurface(const Obstacle& obstacle);

    const ColliderSurface& surface() const { return *of; }
    bool deforms() const { return deformation != nullptr; }
    /// Positions of the points, [3, P] m, at the beginning or at the end of the step.
    const Positions& points(bool at_start) const { return !deforms() ? of->points : at_start ? before : now; }
    /// Bounding box of both shapes.
    const Box& bounds() const { return around; }
    /// Makes the end of the last step the beginning of the next one, which ends at `time` (s).
    void move_to(double time);
    /// Displacements of the points, [3, P] m, from the end of the step to `time` (s); no columns if the
    /// surface is rigid.
    Positions displacement_to(double time) const;
    /// Largest displacement of a point in the step, m.
    double largest_displacement() const;

    void visit_state(StateVisitor& visit) {
        auto& [of, deformation, before, now, around] = *this;
        visit(before, now, around);
    }

  private:
    std::shared_ptr<const ColliderSurface> of;
    std::shared_ptr<const Deformation> deformation;  ///< null: it is rigid
    Positions before, now;                           ///< m, [3, P]; empty if it is rigid
    Box around;
};

/// Poses of a body and of a collider that it may touch.
struct PairPlaces {
    Eigen::Isometry3d here, there;  ///< poses of the body and of the other collider
    bool at_start = false;  ///< whether a deforming other collider has its shape at the step's beginning
};

/// Contact of the surface of a free body with that of another collider, by barrier pairs with continuous
/// collision detection. It covers what point_contacts() leaves out: edges on edges, and bodies that move
/// farther in a step than they are large. In explicit steps the pairs are springs (Barrier), and corners on
/// faces are left to the contact points.
///
/// Contact points act from touching on. So that pairs do, too, they use the body's surface moved inward by a
/// hundredth of its smallest extent, with this distance as activation distance. A ball, which its centre
/// makes exactly round, has its surface moved inward by half of the radius, and pairs only stop what gets
/// that deep. Against a deforming collider, which has no inside, a ball has facets like a mesh. The surface
/// is stored as a sheet without mechanics, so that NearPairs applies.
///
/// Surfaces that intersect or press each other, at the start or after explicit steps, are exempt ("crossed")
/// until they are apart: a barrier would lock them into each other, or drive them apart with energy that
/// nothing has supplied. Contact points push them apart meanwhile. Surfaces that have passed through each
/// other against their springs become exempt, too.
class SurfacePairs {
  public:
    std::size_t body, other;  ///< numbers of the colliders, bodies first; `body` is a free body

    /// core: the body's surface, moved inward. corners: whether contact points find the corners of the body,
    /// and those of the other collider. springs: see ContactSurface.
    SurfacePairs(std::size_t body, const RigidBody& one, std::shared_ptr<const Shell> core, std::size_t other,
                 const Collider& second, OtherSurface surface, std::array<bool, 2> corners, bool springs);

    /// Number, in the pairs, of the body's first vertex; lower numbers are vertices of the other collider.
    Index first() const { return second.surface().size(); }
    bool other_deforms() const { return second.deforms(); }
    /// Advances a deforming surface to `time` (s), see OtherSurface.
    void move_to(double time) { second.move_to(time); }
    /// Positions of a pair's vertices in space, m, [3, 4].
    PairPositions in_space(const std::array<Index, 4>& vertices, const PairPlaces& places) const;
    /// Calls add(pair, at) for each active pair, at: in_space().
    template <class Add>
    void each_active(const PairPlaces& places, Add add) const {
        if (!may_meet(places, places)) return;
        for (const ContactPair& pair : near().active_pairs(in_body_frame(places))) {
            if (is_of_points(pair)) continue;
            ContactPair as_point = pair;
            as_point.stiffness = stiffness;
            add(as_point, in_space(pair.vertices, places));
        }
    }
    /// Number of active pairs.
    int count_active(const PairPlaces& places) const;
    bool touch(const PairPlaces& places) const { return count_active(places) > 0; }
    /// Fraction, 0 to 1, of the straight motion from `from` to `to` up to which the surfaces do not touch.
    double free_fraction(const PairPlaces& from, const PairPlaces& to) const;
    /// See BodyStep.
    bool has_straight_path(const PairPlaces& from, const PairPlaces& to, double widths) const;
    /// Whether the surfaces pass through each other in the straight motion from `from` to `to`.
    bool pass_between(const PairPlaces& from, const PairPlaces& to) const;
    /// Largest displacement (m, in space) from `from` to `to` of a vertex of the other collider near the
    /// body, which rests.
    Vector3d push_displacement(const PairPlaces& from, const PairPlaces& to) const;
    /// Coulomb coefficient of the two colliders.
    double coefficient() const { return friction; }

    /// Whether the surfaces are exempt.
    bool is_crossed() const { return crossed; }
    void set_crossed(bool are) { crossed = are; }
    /// Continues after another time scheme, in which surfaces that were not exempt may press each other.
    void resume(bool was_crossed) {
        crossed = true;
        was_not_exempt = !was_crossed;
    }
    /// Ends the exemption if the surfaces do not intersect and pairs are hardly compressed. After another
    /// time scheme more compression is allowed.
    void update_exemption(const PairPlaces& places);
    /// Sets the poses from which passes() starts.
    void place(const PairPlaces& places);
    /// Whether the surfaces pass through each other in the straight motion from the last place(). If so, they
    /// become exempt.
    bool passes(const PairPlaces& places);
    /// Total stiffness, N/m, of the pairs that may be active until `time` (s) while the body's vertices move
    /// straight by motion(vertices), m, relative to the other collider and in its frame; vertices: in space,
    /// [3, P] m. way: m, bound on the motion of points within radius_of_body().
    template <class Motion>
    double stiffness_within_reach(const PairPlaces& places, double time, double way, Motion motion) const {
        const Positions of_other = second.displacement_to(time);
        if (of_other.cols() > 0) way += std::sqrt(of_other.colwise().squaredNorm().maxCoeff());
        const Eigen::Isometry3d at = places.there.inverse() * places.here;
        if (crossed || !balls_meet(at, at, 1 + way / radius)) return 0;
        return stiffness_along_motion(places, of_other, motion(Positions(places.here * core->rest)));
    }
    /// Radius, m, of a ball around the centre of mass, within which the body's pairs act.
    double radius_of_body() const { return radius; }

    /// Begins a step of `length` (s) from these poses, and finds its sliding pairs.
    void begin(const PairPlaces& places, double length);
    const std::vector<SlidingPair>& sliding() const { return sliding_pairs; }
    /// Displacements, m, [3, 4], of a pair's vertices since the last begin() or place().
    PairPositions moved(const std::array<Index, 4>& vertices, const PairPlaces& places) const {
        return in_space(vertices, places) - in_space(vertices, before);
    }
    void finish(const PairPlaces& places);

    /// Visits the state that is neither given nor computed by begin() or on demand.
    void visit_state(StateVisitor& visit) {
        auto& [body, other, stiffness, friction, of_body, radius, second_young, second, core, corners,
               springs, pairs, before, sliding_pairs, crossed, was_not_exempt, elastic_slip] = *this;
        visit(second, crossed, was_not_exempt, elastic_slip);
    }

  private:
    /// Positions, m, of the other collider's vertices, then of the body's, in the frame of the other
    /// collider.
    Positions in_body_frame(const PairPlaces& places) const;
    /// Whether the surfaces are not exempt, and the ball around the body comes near the other collider in the
    /// straight motion from `from` to `to`.
    bool may_meet(const PairPlaces& from, const PairPlaces& to) const;
    bool balls_meet(const Eigen::Isometry3d& before, const Eigen::Isometry3d& after, double times = 1) const;
    bool cross(const Positions& all) const;
    /// Whether contact points act instead of the pair's spring.
    bool is_of_points(const ContactPair& pair) const {
        return springs && pair.kind == PairKind::vertex_triangle && corners[pair.vertices[0] < first()];
    }
    /// Whether the surfaces do not intersect, and no pair is compressed by more than the share `pressed` of
    /// its range.
    bool apart(const PairPlaces& places, double pressed) const;
    /// See stiffness_within_reach(); of_other: m, motion of the other collider's vertices, without columns if
    /// they rest.
    double stiffness_along_motion(const PairPlaces& places, const Positions& of_other,
                                  const Positions& motion) const;
    const NearPairs& near() const;

    /// N/m, of pairs; Coulomb coefficient; m, smallest extent of the body; m, see radius_of_body().
    double stiffness, friction, of_body, radius;
    double second_young;  ///< Pa
    OtherSurface second;
    std::shared_ptr<const Shell> core;  ///< the body's surface, moved inward
    std::array<bool, 2> corners;  ///< whether contact points find the corners of body and other collider
    bool springs;
    mutable std::unique_ptr<NearPairs> pairs;  ///< made when the two come near, since most never do
    PairPlaces before{Eigen::Isometry3d::Identity(), Eigen::Isometry3d::Identity(), true};
    std::vector<SlidingPair> sliding_pairs;
    bool crossed = true;  ///< whether the surfaces are exempt; assumed until update_exemption()
    bool was_not_exempt =
        false;  ///< whether they were not exempt with another time scheme, until update_exemption()
    StickMemory<PairKey> elastic_slip;
};

/// Makes the pairs of the surfaces of all bodies with each other and with obstacles that have one. Of a ball
/// and another body the ball is the first. springs: see ContactSurface. crossed: for each result, whether it
/// was exempt with another time scheme; empty: there was none.
std::vector<std::unique_ptr<SurfacePairs>> surface_pairs(const std::vector<RigidBody>& bodies,
                                                         const std::vector<Obstacle>& obstacles,
                                                         std::span<const char> crossed, bool springs = false);
/// Whether each of the pairs is exempt.
std::vector<char> crossed_surfaces(std::span<const std::unique_ptr<SurfacePairs>> all);

}  // namespace sherd
