// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <span>

#include "core/contact/bodies/body_step.h"
#include "core/contact/colliders/obstacle.h"
#include "core/contact/detection/box_tree.h"
#include "core/state_visitor.h"

namespace sherd {

/// The surface of a collider that a body may touch, in the collider's frame. A deforming surface has two
/// shapes: one at the beginning and one at the end of a step or a substep.
class OtherSurface {
  public:
    explicit OtherSurface(const Collider& collider);
    /// Surface of an obstacle, which may deform.
    explicit OtherSurface(const Obstacle& obstacle);

    const ColliderSurface& surface() const { return *of; }
    bool deforms() const { return deformation != nullptr; }
    /// Positions of the points, [3, P] m, at the beginning or at the end of the step.
    const Positions& points(bool at_start) const { return !deforms() ? of->points : at_start ? before : now; }
    /// Bounding box of the surface, for a deforming one of its two shapes together.
    const Box& bounds() const { return around; }
    /// Begins the next step, which ends at `time` (s): the shape at the end of the last step becomes the
    /// shape at the beginning.
    void move_to(double time);
    /// Displacements of the points, [3, P] m, from the end of the step to `time` (s); without columns if the
    /// surface is rigid.
    Positions displacement_to(double time) const;
    /// Largest displacement of a point in the step, m, in the collider's frame.
    double largest_displacement() const;

    void visit_state(StateVisitor& visit) {
        auto& [of, deformation, before, now, around] = *this;
        visit(before, now, around);
    }

  private:
    std::shared_ptr<const ColliderSurface> of;
    std::shared_ptr<const Deformation> deformation;  ///< null: the surface is rigid
    Positions before, now;  ///< m, [3, P], the two shapes; empty if the surface is rigid
    Box around;             ///< see bounds()
};

/// Poses of a body and of a collider that it may touch.
struct PairPlaces {
    Eigen::Isometry3d here, there;  ///< pose of the body; pose of the other collider
    /// Whether the other collider, if it deforms, has its shape at the step's beginning instead of its end.
    bool at_start = false;
};

/// Contact of the surface of a free body with the surface of another collider, by barrier pairs with
/// continuous collision detection. The pairs cover the contacts that point_contacts() does not find: edges on
/// edges, and bodies that move in a step farther than their own size. In explicit steps the pairs are springs
/// (Barrier), and only the contact points act between corners and faces.
///
/// Contact points begin to act when the two colliders touch. So that pairs begin to act there, too, they use
/// the body's surface moved inward ("core") by a hundredth of the body's smallest extent, with this distance
/// as activation distance. The core of a ball is its surface moved inward by half of the radius, since the
/// contact point at its centre acts on an exact sphere, not on facets: pairs only stop colliders that get so
/// deep. Against a deforming collider, which has no inside, contact points do not act, and the core of a ball
/// is made like the core of any other body. The core is stored as a sheet without mechanics, so that
/// NearPairs applies.
///
/// Two surfaces that intersect or press each other, at the start of a run or after explicit steps, are exempt
/// from pairs ("crossed") until they are apart: barriers would lock them into each other, or drive them apart
/// with energy that no work has supplied. Contact points push them apart meanwhile. Two surfaces that have
/// passed through each other in spite of their springs become exempt, too.
class SurfacePairs {
  public:
    /// Numbers of the two colliders, bodies first; `body` is a free body.
    std::size_t body, other;

    /// body, one: the free body's number and state; other, second: number and state of the other collider,
    /// whose surface is `surface`. core: the body's surface, moved inward. corners: whether contact points
    /// find the contacts of the body's corners, and of the other collider's corners. springs: see
    /// ContactSurface.
    SurfacePairs(std::size_t body, const RigidBody& one, std::shared_ptr<const Shell> core, std::size_t other,
                 const Collider& second, OtherSurface surface, std::array<bool, 2> corners, bool springs);

    /// Number of the body's first vertex in pairs; vertices of the other collider have lower numbers.
    Index first() const { return second.surface().size(); }
    bool other_deforms() const { return second.deforms(); }
    /// Advances a deforming surface to `time` (s), see OtherSurface.
    void move_to(double time) { second.move_to(time); }
    /// Positions of a pair's vertices in space, m, [3, 4].
    PairPositions in_space(const std::array<Index, 4>& vertices, const PairPlaces& places) const;
    /// Calls add(pair, at) for each active pair that contact points do not replace; at: positions of its
    /// vertices, see in_space().
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
    /// Number of pairs for which each_active() calls its function.
    int count_active(const PairPlaces& places) const;
    bool touch(const PairPlaces& places) const { return count_active(places) > 0; }
    /// Fraction, 0 to 1, of the straight motion from `from` to `to` up to which the distance of all pairs
    /// stays above its minimum; less if the bodies turn by more than largest_turn.
    double free_fraction(const PairPlaces& from, const PairPlaces& to) const;
    /// Whether the body, if it moved without rotation from `from` to `to`, would end at most `widths` times
    /// its smallest extent beyond its first contact with the other collider.
    bool has_straight_path(const PairPlaces& from, const PairPlaces& to, double widths) const;
    /// Whether the surfaces pass through each other in the straight motion from `from` to `to`.
    bool pass_between(const PairPlaces& from, const PairPlaces& to) const;
    /// Among the vertices of the other collider that come near the body, which rests, returns the largest
    /// displacement (m, in space) from `from` to `to`.
    Vector3d push_displacement(const PairPlaces& from, const PairPlaces& to) const;
    /// Coulomb coefficient between the two colliders.
    double coefficient() const { return friction; }

    /// Whether the surfaces are exempt.
    bool is_crossed() const { return crossed; }
    void set_crossed(bool are) { crossed = are; }
    /// Continues after steps of another time scheme: the surfaces are exempt until update_exemption(), which
    /// allows more compression if they were not exempt in that scheme.
    void resume(bool was_crossed) {
        crossed = true;
        was_not_exempt = !was_crossed;
    }
    /// Ends the exemption if the surfaces do not intersect and no pair is compressed by more than a small
    /// share of its range; see resume() for the larger share after another time scheme.
    void update_exemption(const PairPlaces& places);
    /// Sets the poses from which passes() starts.
    void place(const PairPlaces& places);
    /// Whether the surfaces pass through each other in the straight motion from the poses of the last place()
    /// to `places`. If so, they become exempt.
    bool passes(const PairPlaces& places);
    /// Total stiffness, N/m, of the pairs that may be active until `time` (s). motion(vertices): returns the
    /// displacements, [3, P] m, of the body's vertices until then, relative to the other collider and in its
    /// frame; vertices: their positions in space, [3, P] m. way: m, upper bound on such displacements of
    /// points within radius_of_body().
    template <class Motion>
    double stiffness_within_reach(const PairPlaces& places, double time, double way, Motion motion) const {
        const Positions of_other = second.displacement_to(time);
        if (of_other.cols() > 0) way += std::sqrt(of_other.colwise().squaredNorm().maxCoeff());
        const Eigen::Isometry3d at = places.there.inverse() * places.here;
        if (crossed || !balls_meet(at, at, 1 + way / radius)) return 0;
        return stiffness_along_motion(places, of_other, motion(Positions(places.here * core->rest)));
    }
    /// Radius, m, of the ball around the body's centre of mass within which its pairs act.
    double radius_of_body() const { return radius; }

    /// Begins a step of `length` (s) from these poses, and finds its sliding pairs.
    void begin(const PairPlaces& places, double length);
    const std::vector<SlidingPair>& sliding() const { return sliding_pairs; }
    /// Displacements, m, [3, 4], of a pair's vertices since the last begin() or place().
    PairPositions moved(const std::array<Index, 4>& vertices, const PairPlaces& places) const {
        return in_space(vertices, places) - in_space(vertices, before);
    }
    /// Ends the step at these poses: stores the elastic slip of the sliding pairs.
    void finish(const PairPlaces& places);

    /// Visits the state, except the members that the constructor or begin() sets or that are computed on
    /// demand.
    void visit_state(StateVisitor& visit) {
        auto& [body, other, stiffness, friction, of_body, radius, second_young, second, core, corners,
               springs, pairs, before, sliding_pairs, crossed, was_not_exempt, elastic_slip] = *this;
        visit(second, crossed, was_not_exempt, elastic_slip);
    }

  private:
    /// Positions, m, of the other collider's vertices, then of the body's, in the frame of the other
    /// collider.
    Positions in_body_frame(const PairPlaces& places) const;
    /// Whether the surfaces are not exempt, and the ball of radius_of_body() may touch the other collider's
    /// bounding box in the straight motion from `from` to `to`.
    bool may_meet(const PairPlaces& from, const PairPlaces& to) const;
    /// Whether the ball of `times` the radius_of_body() around the body, whose pose in the other collider's
    /// frame changes from `before` to `after`, may touch the other collider's bounding box.
    bool balls_meet(const Eigen::Isometry3d& before, const Eigen::Isometry3d& after, double times = 1) const;
    /// Whether the surfaces intersect; all: see in_body_frame().
    bool cross(const Positions& all) const;
    /// Whether contact points act instead of the pair's spring.
    bool is_of_points(const ContactPair& pair) const {
        return springs && pair.kind == PairKind::vertex_triangle && corners[pair.vertices[0] < first()];
    }
    /// Whether the surfaces do not intersect, and no pair is compressed by more than the share `pressed` of
    /// its range.
    bool apart(const PairPlaces& places, double pressed) const;
    /// Result of stiffness_within_reach(). motion: [3, P] m, displacements of the body's vertices; of_other:
    /// m, displacements of the other collider's vertices in its frame, without columns if it is rigid.
    double stiffness_along_motion(const PairPlaces& places, const Positions& of_other,
                                  const Positions& motion) const;
    const NearPairs& near() const;

    /// stiffness: N/m, of each pair; friction: Coulomb coefficient; of_body: m, smallest extent of the body;
    /// radius: m, see radius_of_body().
    double stiffness, friction, of_body, radius;
    double second_young;  ///< Pa, Young's modulus of the other collider
    OtherSurface second;
    std::shared_ptr<const Shell> core;  ///< the body's surface, moved inward
    /// Whether contact points find the contacts of the corners of the body, and of the other collider.
    std::array<bool, 2> corners;
    bool springs;
    /// Null until the body comes near the other collider, since most bodies never do.
    mutable std::unique_ptr<NearPairs> pairs;
    PairPlaces before{Eigen::Isometry3d::Identity(), Eigen::Isometry3d::Identity(), true};
    std::vector<SlidingPair> sliding_pairs;
    bool crossed = true;          ///< whether the surfaces are exempt; assumed until update_exemption()
    bool was_not_exempt = false;  ///< see resume(); false after update_exemption()
    StickMemory<PairKey> elastic_slip;
};

/// Returns a SurfacePairs for each two bodies with surfaces, and for each body and obstacle with surfaces. If
/// one of two bodies is a ball, SurfacePairs::body is the ball. springs: see ContactSurface. crossed: for
/// each result, whether its surfaces were exempt in steps of another time scheme before; empty if there were
/// no such steps.
std::vector<std::unique_ptr<SurfacePairs>> surface_pairs(const std::vector<RigidBody>& bodies,
                                                         const std::vector<Obstacle>& obstacles,
                                                         std::span<const char> crossed, bool springs = false);
/// Returns for each element of `all` whether its surfaces are exempt.
std::vector<char> crossed_surfaces(std::span<const std::unique_ptr<SurfacePairs>> all);

}  // namespace sherd
