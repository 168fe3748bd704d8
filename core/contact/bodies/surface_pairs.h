// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <span>

#include "core/contact/bodies/body_step.h"
#include "core/contact/bodies/met_surface.h"

namespace sherd {

/// Where a body is, and what it meets.
struct PairPlaces {
    Eigen::Isometry3d here, there;  ///< poses of the body and of the other one
    bool at_start = false;  ///< whether the other one, if it deforms, has its shape of where the step begins
};

/// The surface of a free body against that of another collider, as barrier pairs with continuous detection:
/// what the points of point_contacts() leave out, edges on edges, and what is faster than it is large. In
/// explicit steps they are springs (Barrier), and what corners meet is left to the points.
///
/// Points push from touching on, so what makes the pairs is the body's surface moved inward, by a hundredth
/// of its smallest extent, and they are active within that distance of the other surface: from touching on,
/// too. Of a ball, which its centre makes exactly round, it is half of the radius, and the pairs are only
/// what stops it there. Beside what deforms, and has no inside, it has facets as a mesh has. The surface is
/// taken as a sheet that has no mechanics, so that all of NearPairs is there.
///
/// Surfaces that cross or press each other, at the start or because explicit steps let them, do not see each
/// other until they are apart: a barrier would hold them in each other, or throw them apart with energy from
/// nowhere. Points push them meanwhile. So it is with what has overwhelmed springs.
class SurfacePairs {
  public:
    std::size_t body, other;  ///< numbers of the colliders, bodies first; the first is free

    /// core: the surface of the body, moved inward. corners: whether points find the corners of the body, and
    /// those of the other one. springs: see ContactSurface.
    SurfacePairs(std::size_t body, const RigidBody& one, std::shared_ptr<const Shell> core, std::size_t other,
                 const Collider& second, MetSurface surface, std::array<bool, 2> corners, bool springs);

    /// The number, in the pairs, of the first vertex of the body; those before are the other's.
    Index first() const { return second.surface().size(); }
    bool other_deforms() const { return second.deforms(); }
    /// The step goes on to `time` (s), as what deforms sees it.
    void move_to(double time) { second.move_to(time); }
    /// Where they are in space, m, [3, 4].
    PairPositions in_space(const std::array<Index, 4>& vertices, const PairPlaces& places) const;
    /// Calls add(pair, at) for each active pair, at: in_space().
    template <class Add>
    void each_active(const PairPlaces& places, Add add) const {
        if (!may_meet(places, places)) return;
        for (const ContactPair& pair : near().active_pairs(seen(places))) {
            if (is_of_points(pair)) continue;
            ContactPair as_point = pair;
            as_point.stiffness = stiffness;
            add(as_point, in_space(pair.vertices, places));
        }
    }
    /// How many there are.
    int count_active(const PairPlaces& places) const;
    bool touch(const PairPlaces& places) const { return count_active(places) > 0; }
    /// Fraction, 0 to 1, of the straight way from places to others on which the surfaces do not meet.
    double free_way(const PairPlaces& from, const PairPlaces& to) const;
    /// See BodyStep.
    bool has_straight_way(const PairPlaces& from, const PairPlaces& to, double widths) const;
    /// Whether the surfaces pass through each other on the straight way from places to others.
    bool pass_between(const PairPlaces& from, const PairPlaces& to) const;
    /// By what, m, in space, what deforms moves between these places where the body, which stays, is in its
    /// way.
    Vector3d pushed_along(const PairPlaces& from, const PairPlaces& to) const;
    /// Coulomb coefficient of the two.
    double coefficient() const { return friction; }

    /// Whether the surfaces do not see each other.
    bool is_crossed() const { return crossed; }
    void set_crossed(bool are) { crossed = are; }
    /// Goes on as it was with another time scheme, which may have let what is not crossed press each other.
    void go_on(bool was_crossed) {
        crossed = true;
        seen_before = !was_crossed;
    }
    /// Lets surfaces see each other that do not, once they do not cross, and pairs press by next to nothing.
    void look(const PairPlaces& places);
    /// Where the two are, from which passes() goes on.
    void place(const PairPlaces& places);
    /// Whether the surfaces pass through each other on the straight way from where they were placed last.
    /// Those that do see each other no more.
    bool passes(const PairPlaces& places);
    /// N/m, of all pairs together that may be active until `time` (s) while the body's vertices move straight
    /// by motion(vertices) m, as seen from the other one; vertices: in space, [3, P] m. No point within
    /// radius_of_body() moves farther than `way`, m.
    template <class Motion>
    double stiffness_within_reach(const PairPlaces& places, double time, double way, Motion motion) const {
        const Positions of_other = second.way_to(time);
        if (of_other.cols() > 0) way += std::sqrt(of_other.colwise().squaredNorm().maxCoeff());
        const Eigen::Isometry3d at = places.there.inverse() * places.here;
        if (crossed || !balls_meet(at, at, 1 + way / radius)) return 0;
        return stiffness_on_way(places, of_other, motion(Positions(places.here * core->rest)));
    }
    /// How far, m, the body's vertices are from its centre of mass at most.
    double radius_of_body() const { return radius; }

    /// Begins a step of `length` (s) at places, and its friction.
    void begin(const PairPlaces& places, double length);
    const std::vector<SlidingPair>& sliding() const { return sliding_pairs; }
    /// Displacements, m, [3, 4], of a pair's vertices in the step, or since they were placed.
    PairPositions moved(const std::array<Index, 4>& vertices, const PairPlaces& places) const {
        return in_space(vertices, places) - in_space(vertices, before);
    }
    void finish(const PairPlaces& places);

    /// The rest is given, or made by begin() or when it is needed.
    void visit_state(StateVisitor& visit) {
        auto& [body, other, stiffness, friction, of_body, radius, second_young, second, core, corners,
               springs, pairs, before, sliding_pairs, crossed, seen_before, held] = *this;
        visit(second, crossed, seen_before, held);
    }

  private:
    /// m, of the other's vertices and the body's, in the frame of the other one.
    Positions seen(const PairPlaces& places) const;
    /// Whether the surfaces see each other, and balls around the body come near the other one somewhere on
    /// the straight way from places to others.
    bool may_meet(const PairPlaces& from, const PairPlaces& to) const;
    bool balls_meet(const Eigen::Isometry3d& before, const Eigen::Isometry3d& after, double times = 1) const;
    bool cross(const Positions& all) const;
    /// Whether points meet instead of a spring.
    bool is_of_points(const ContactPair& pair) const {
        return springs && pair.kind == PairKind::vertex_triangle && corners[pair.vertices[0] < first()];
    }
    /// Whether the surfaces do not cross, and no pair presses by more than this share of its range.
    bool apart(const PairPlaces& places, double pressed) const;
    /// See stiffness_within_reach(); of_other: m, of the other's vertices, without columns if they rest.
    double stiffness_on_way(const PairPlaces& places, const Positions& of_other,
                            const Positions& motion) const;
    const NearPairs& near() const;

    double stiffness, friction, of_body, radius;  ///< m, of a ball around the body within which pairs act
    double second_young;                          ///< Pa
    MetSurface second;
    std::shared_ptr<const Shell> core;  ///< the body's surface, moved inward
    std::array<bool, 2> corners;        ///< whether points find those of the body, of the other one
    bool springs;
    mutable std::unique_ptr<NearPairs> pairs;  ///< made when the two come near, since most never do
    PairPlaces before{Eigen::Isometry3d::Identity(), Eigen::Isometry3d::Identity(), true};
    std::vector<SlidingPair> sliding_pairs;
    bool crossed = true;       ///< as far as is known, until they are looked at
    bool seen_before = false;  ///< with another time scheme, until they are looked at
    StickMemory<PairKey> held;
};

/// Those of all bodies with each other and with obstacles that have a surface. Of a ball and another body the
/// ball is the first. springs: see ContactSurface. crossed: of each of them, whether it was so with another
/// time scheme; empty: there was none.
std::vector<std::unique_ptr<SurfacePairs>> surface_pairs(const std::vector<RigidBody>& bodies,
                                                         const std::vector<Obstacle>& obstacles,
                                                         std::span<const char> crossed, bool springs = false);
/// Whether each of them is.
std::vector<char> crossed_surfaces(std::span<const std::unique_ptr<SurfacePairs>> all);

}  // namespace sherd
