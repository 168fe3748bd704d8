// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "core/contact/colliders/contact_colliders.h"
#include "core/contact/detection/near_pairs.h"
#include "core/element_energy.h"
#include "core/reaction.h"
#include "core/state_visitor.h"

namespace sherd {

/// Contact of sheets and fragments with each other, with themselves and with the surfaces of colliders: the
/// sum of the barriers of all vertex-triangle and edge-edge pairs that are closer than half the sum of their
/// thicknesses (Li et al. 2020, with the thickness of Li, Kaufman, Jiang 2021). It is infinite where a pair
/// is closer than its minimum, which no motion up to safe_fraction() reaches.
class SheetContact : public Energy {
  public:
    /// The shell must outlive this object. sheets_meet: whether elements of sheets collide with each other.
    /// springs: see ContactSurface. threads: share the search for pairs and the computation of forces.
    explicit SheetContact(const Shell& shell, std::vector<Obstacle> obstacles = {}, bool sheets_meet = true,
                          bool springs = false, Threads threads = Threads());
    /// Places the colliders; energies are evaluated with them at the end of the step.
    void begin(const StepContext& step) override;
    void topology_changed(const ShellChange& change, const StepContext& step) override;
    /// Must be called when the shell, or its exempt vertices, have changed.
    void surface_changed(const ShellChange& change);

    double value(const Positions& x) const override;
    void add_gradient(const Positions& x, Positions& gradient) const override;
    void add_hessian(const Positions& x, Curvature curvature, BlockMatrix& hessian) const override;
    Task task() const override { return Task::contact; }
    void add_contacts(const Positions& x, bool ahead,
                      std::vector<std::pair<Index, Index>>& pairs) const override;
    double safe_fraction(const Positions& x, const Positions& motion) const override;
    double stored_at_start() const;  ///< value() at the beginning of the step, J

    /// safe_fraction() from the shell at x and the colliders at the beginning of the step, with the motion of
    /// the colliders in the step included.
    double safe_fraction_of_step(const Positions& x, const Positions& motion) const;
    /// For each vertex that is near a moving collider, or will be, the displacement of the collider in the
    /// step; zero for the other vertices. x: positions at the beginning of the step. [3, V] m.
    Positions push_displacement(const Positions& x) const;

    const ContactSurface& surface() const { return near.surface(); }
    /// Number of the obstacle to which a vertex of colliders, numbered as in surface(), belongs.
    std::size_t obstacle_number(Index vertex) const { return obstacle_of[surface().collider_number(vertex)]; }
    /// The colliders' vertices at the end of the step, or at its beginning, followed by x [3, V], as
    /// surface() numbers them, [3, surface().vertices()].
    const Positions& at_end(const Positions& x) const { return with(end, x); }
    Positions at_start(const Positions& x) const { return with(start, x); }
    const Positions& colliders_at_start() const { return start; }  ///< [3, S] m
    /// The active pairs at x, ascending, vertex-triangle pairs first. They are valid until the next call.
    const std::vector<ContactPair>& active_pairs(const Positions& x) const {
        return near.active_pairs(at_end(x));
    }
    /// Active pairs at positions that at_end() has returned.
    const std::vector<ContactPair>& active_pairs_of(const Positions& all) const {
        return near.active_pairs(all);
    }
    /// A superset of the active pairs and of all pairs that are nearer than a tenth of the thinnest sheet's
    /// thickness.
    std::vector<ContactPair> pairs_nearby(const Positions& x) const { return near.pairs_nearby(at_end(x)); }
    /// Active pairs at x, with the colliders at the beginning of the step.
    const std::vector<ContactPair>& active_pairs_at_start(const Positions& x) const {
        return near.active_pairs(with(start, x));
    }
    /// The pairs that may be active somewhere in the step, in which the shell moves straight from x.
    std::vector<ContactPair> pairs_within_reach(const Positions& x, const Positions& motion) const {
        return near.pairs_within_reach(with(start, x), with_colliders(motion));
    }
    /// Adds the forces of the colliders' surfaces on sheets at x to the reactions, one for each obstacle.
    void add_reactions(const Positions& x, std::span<Reaction> of_obstacles) const {
        add_reactions(pairs_at(at_end(x)), x, of_obstacles);
    }
    /// Adds the forces of other elements on the vertices of surface() to the reactions.
    template <class Elements>
    void add_reactions(const Elements& elements, const Positions& x, std::span<Reaction> of_obstacles) const {
        const Index first = surface().collider_vertices();
        for (std::size_t i = 0; i < elements.size(); ++i) {
            const std::array<Index, 4> vertices = elements.vertices(i);
            const Index least = *std::min_element(vertices.begin(), vertices.end());
            if (least >= 0) continue;  // two sheets
            const PairPositions gradient = elements.gradient(i, elements.gather(i, x));
            Reaction& reaction = of_obstacles[obstacle_number(least + first)];
            for (int v = 0; v < 4; ++v)
                if (vertices[v] >= 0) reaction.add(x.col(vertices[v]), -gradient.col(v));
        }
    }
    /// Work, J, of deforming obstacles on the shell at x in the step, from the forces on their vertices.
    double work_of_deforming(const Positions& x) const { return work_of_deforming(pairs_at(at_end(x)), x); }
    /// Work, J, in the step, of the forces of other elements on the vertices of deforming obstacles.
    template <class Elements>
    double work_of_deforming(const Elements& elements, const Positions& x) const {
        double sum = 0;
        const Index first = surface().collider_vertices();
        for (std::size_t i = 0; i < elements.size(); ++i) {
            const std::array<Index, 4> vertices = elements.vertices(i);
            const Index least = *std::min_element(vertices.begin(), vertices.end());
            if (least >= 0 || obstacles[obstacle_number(least + first)].deformation == nullptr) continue;
            const PairPositions gradient = elements.gradient(i, elements.gather(i, x));
            for (int v = 0; v < 4; ++v)
                if (vertices[v] < 0) sum += gradient.col(v).dot(collider_displacement(vertices[v] + first));
        }
        return sum;
    }
    /// Displacement, m, of a vertex of colliders in the step.
    Vector3d collider_displacement(Index vertex) const { return end.col(vertex) - start.col(vertex); }
    /// Adds the vertices that touch colliders at x, and the surfaces of these colliders.
    void add_touched(const Positions& x, std::set<Index>& vertices,
                     std::set<const ColliderSurface*>& touched) const {
        near.add_touched(at_end(x), vertices, touched);
    }
    /// A message with the vertices of the first pair that is closer than its minimum at the beginning of the
    /// step, where the shell is at x; nothing if there is none.
    std::optional<std::string> overlap(const Positions& x) const;
    /// Whether pairs that are springs could be barriers, with the shell at x at the end of the step.
    bool allows_barriers(const Positions& x) const { return near.allow_barriers(at_end(x)); }
    /// See NearPairs; colliders are at the beginning of the step, or at its end.
    double least_share_at_start(const Positions& x) const { return near.least_share(with(start, x)); }
    double least_share_at_end(const Positions& x) const { return near.least_share(with(end, x)); }
    void set_second_spring(SecondSpring second_spring) { near.set_second_spring(second_spring); }
    /// Whether sheets pass through each other, or through a collider, in the step of the last begin(). The
    /// shell moves straight from x, colliders by their prescribed motion.
    bool passes(const StepContext& step, const Positions& x, const Positions& end_of_shell) const;
    void visit_state(StateVisitor& visit) override {
        auto& [shell, threads, obstacles, obstacle_of, colliders, near, start, end, whole] = *this;
        visit(near, start, end);
    }

  private:
    /// The active pairs, as elements.
    struct Pairs {
        const std::vector<ContactPair>& pairs;
        const Positions& all;  ///< m, of colliders and sheets
        Index first;           ///< number of the first vertex of sheets

        std::size_t size() const { return pairs.size(); }
        std::array<Index, 4> vertices(std::size_t i) const { return numbered_from(pairs[i].vertices, first); }
        PairPositions gather(std::size_t i, const Positions&) const {
            return columns(all, pairs[i].vertices);
        }
        double value(std::size_t i, const PairPositions& x) const { return sherd::value(pairs[i], x); }
        PairPositions gradient(std::size_t i, const PairPositions& x) const {
            return sherd::gradient(pairs[i], x);
        }
        PairHessian hessian(std::size_t i, const PairPositions& x, Curvature curvature) const {
            return sherd::hessian(pairs[i], x, curvature == Curvature::convex);
        }
    };

    /// The motions of colliders in the step, followed by that of the shell.
    Positions with_colliders(const Positions& motion) const;
    Pairs pairs_at(const Positions& all) const;
    /// The two arrays joined, valid until the next call.
    const Positions& with(const Positions& collider, const Positions& x) const;

    const Shell& shell;
    Threads threads;
    std::vector<Obstacle> obstacles;
    std::vector<std::size_t> obstacle_of;  ///< number of each collider's obstacle
    std::vector<ContactCollider> colliders;
    NearPairs near;
    Positions start, end;     ///< m, [3, S], vertices of all colliders in their order
    mutable Positions whole;  ///< buffer, kept to save allocations
};

}  // namespace sherd
