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
/// sum of the barriers of all vertex-triangle and edge-edge pairs that are closer than their activation
/// distance, about half the sum of their thicknesses (Li et al. 2020, with the thickness of Li, Kaufman,
/// Jiang 2021; see ContactSurface). Unless pairs are springs, the energy is infinite where a pair is closer
/// than its minimum distance, which no motion up to safe_fraction() reaches. S is the number of the
/// colliders' vertices, V the number of the shell's.
class SheetContact : public Energy {
  public:
    /// The shell must outlive this object. sheets_meet: whether elements of sheets collide with each other.
    /// springs: see ContactSurface. threads: they share the search for pairs and the computation of forces.
    explicit SheetContact(const Shell& shell, std::vector<Obstacle> obstacles = {}, bool sheets_meet = true,
                          bool springs = false, Threads threads = Threads());
    /// Places the colliders at the beginning and the end of the step. value() and its derivatives are
    /// evaluated with the colliders at the end of the step.
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

    /// The fraction of safe_fraction() for a motion of the shell from x, and of the colliders from their
    /// positions at the beginning of the step to the end.
    double safe_fraction_of_step(const Positions& x, const Positions& motion) const;
    /// Returns [3, V] m, for each vertex of the shell: the displacement, in the step, of the moving collider
    /// that the vertex is near at some moment of the step if it rests at x; zero if there is no such
    /// collider. x: positions at the beginning of the step.
    Positions push_displacement(const Positions& x) const;

    const ContactSurface& surface() const { return near.surface(); }
    /// Number of the obstacle to which `vertex` belongs, a vertex of colliders numbered as in surface().
    std::size_t obstacle_number(Index vertex) const { return obstacle_of[surface().collider_number(vertex)]; }
    /// The colliders' vertices at the end (at_end) or at the beginning (at_start) of the step, followed by x
    /// [3, V]: [3, S + V] m, in the order of surface(). The result of at_end() is valid until the next call
    /// of a function of this object.
    const Positions& at_end(const Positions& x) const { return with(end, x); }
    Positions at_start(const Positions& x) const { return with(start, x); }
    const Positions& colliders_at_start() const { return start; }  ///< [3, S] m, their vertices
    /// Returns the active pairs at x, with the colliders at the end of the step: ascending, vertex-triangle
    /// pairs first. The list is valid until the next call.
    const std::vector<ContactPair>& active_pairs(const Positions& x) const {
        return near.active_pairs(at_end(x));
    }
    /// Active pairs at `all`, positions that at_end() has returned.
    const std::vector<ContactPair>& active_pairs_of(const Positions& all) const {
        return near.active_pairs(all);
    }
    /// Returns a superset of the pairs that are active at x or whose distance there is less than a tenth of
    /// the thinnest sheet's thickness.
    std::vector<ContactPair> pairs_nearby(const Positions& x) const { return near.pairs_nearby(at_end(x)); }
    /// Active pairs at x, with the colliders at the beginning of the step.
    const std::vector<ContactPair>& active_pairs_at_start(const Positions& x) const {
        return near.active_pairs(with(start, x));
    }
    /// Returns the pairs that may be active somewhere in the step, in which the shell moves from x straight
    /// by `motion`.
    std::vector<ContactPair> pairs_within_reach(const Positions& x, const Positions& motion) const {
        return near.pairs_within_reach(with(start, x), with_colliders(motion));
    }
    /// Adds the forces that the colliders' surfaces exert on sheets at x to `of_obstacles`, which has one
    /// reaction for each obstacle.
    void add_reactions(const Positions& x, std::span<Reaction> of_obstacles) const {
        add_reactions(pairs_at(at_end(x)), x, of_obstacles);
    }
    /// Adds the forces that `elements` between sheets and colliders, such as friction, exert on sheets at x
    /// to the reactions `of_obstacles`. The elements' vertices are numbered as in surface(), less the number
    /// of the colliders' vertices, so that vertices of colliders have negative numbers.
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
    /// Work, J, that deforming obstacles do in the step against the contact forces on their vertices, for the
    /// shell at x.
    double work_of_deforming(const Positions& x) const { return work_of_deforming(pairs_at(at_end(x)), x); }
    /// Work, J, that deforming obstacles do in the step against the forces of `elements` on their vertices;
    /// the elements are numbered as in add_reactions().
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
    /// Displacement, m, in the step, of a vertex of colliders, numbered as in surface().
    Vector3d collider_displacement(Index vertex) const { return end.col(vertex) - start.col(vertex); }
    /// Adds the vertices of the shell that touch colliders at x to `vertices`, and the surfaces of these
    /// colliders to `touched`.
    void add_touched(const Positions& x, std::set<Index>& vertices,
                     std::set<const ColliderSurface*>& touched) const {
        near.add_touched(at_end(x), vertices, touched);
    }
    /// Returns an error message with the vertices of the first pair that is closer than its minimum distance
    /// at the beginning of the step, where the shell is at x; nothing if there is no such pair.
    std::optional<std::string> overlap(const Positions& x) const;
    /// Whether pairs that are springs could be barriers, with the shell at x and the colliders at the end of
    /// the step.
    bool allows_barriers(const Positions& x) const { return near.allow_barriers(at_end(x)); }
    /// See NearPairs::least_share(): the colliders are at the beginning (at_start) or at the end (at_end) of
    /// the step.
    double least_share_at_start(const Positions& x) const { return near.least_share(with(start, x)); }
    double least_share_at_end(const Positions& x) const { return near.least_share(with(end, x)); }
    void set_second_spring(SecondSpring second_spring) { near.set_second_spring(second_spring); }
    /// Whether sheets pass through each other, or through a collider, in `step`, the step of the last
    /// begin(). The shell moves straight from x to end_of_shell, colliders by their prescribed motion.
    bool passes(const StepContext& step, const Positions& x, const Positions& end_of_shell) const;
    void visit_state(StateVisitor& visit) override {
        auto& [shell, threads, obstacles, obstacle_of, colliders, near, start, end, whole] = *this;
        visit(near, start, end);
    }

  private:
    /// The active pairs, as elements whose vertices are numbered as in add_reactions().
    struct Pairs {
        const std::vector<ContactPair>& pairs;
        const Positions& all;  ///< [3, S + V] m, positions of colliders and sheets
        Index first;           ///< number of the first vertex of sheets in surface()

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

    /// The displacements of the colliders' vertices in the step, followed by the shell's, `motion`: [3, S +
    /// V] m.
    Positions with_colliders(const Positions& motion) const;
    Pairs pairs_at(const Positions& all) const;
    /// The positions `collider`, followed by x. The result is valid until the next call.
    const Positions& with(const Positions& collider, const Positions& x) const;

    const Shell& shell;
    Threads threads;
    std::vector<Obstacle> obstacles;
    std::vector<std::size_t> obstacle_of;  ///< for each collider, the number of its obstacle
    std::vector<ContactCollider> colliders;
    NearPairs near;
    Positions start, end;     ///< [3, S] m, colliders' vertices at beginning and end of the step
    mutable Positions whole;  ///< result of with(), kept to save allocations
};

}  // namespace sherd
