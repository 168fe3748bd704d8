// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/contact/explicit/explicit_contact.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>
#include <stdexcept>

#include "core/contact/explicit/contact_forces.h"
#include "core/energy_balance.h"

namespace sherd {
namespace {

/// Weight in a pair that a vertex has at least while closest points slide.
constexpr double least_weight = 0.01;
/// Factor of the motion that velocities predict for a step: forces change velocities.
constexpr double margin_of_motion = 1.5;
constexpr std::uint8_t stiffest_second_spring = 2, most_halvings = 3;

}  // namespace

ExplicitContact::ExplicitContact(const Shell& shell, ContactOptions given, const ContactStart& start,
                                 const Vector3d& gravity, const Threads& threads)
    : options(std::move(given)),
      shell(shell),
      threads(threads),
      bodies(shell, start.bodies, options.obstacles, gravity, start.crossed),
      crack_faces(shell.crack_faces),
      gravity(gravity) {
    const std::vector<Obstacle>& obstacles = options.obstacles;
    for (const Obstacle& obstacle : obstacles) at_vertices.emplace_back(shell, obstacle, at_vertices.size());
    place(0, 0);
    look_everywhere();
    const bool surfaces =
        std::ranges::any_of(obstacles, [](const Obstacle& obstacle) { return obstacle.surface != nullptr; });
    if (options.sheets || surfaces)
        sheets = std::make_unique<SheetContact>(shell, obstacles, options.sheets, true, threads);
}

void ExplicitContact::place(double from, double time) {
    before.clear();
    now.clear();
    for (const Obstacle& obstacle : options.obstacles) {
        before.push_back(obstacle.motion.at(from));
        now.push_back(obstacle.motion.at(time));
    }
    substep.begin = from;
    substep.length = time - from;
    if (sheets) sheets->begin(substep);
    bodies.move_to(time);
}

void ExplicitContact::begin(double time, bool first) {
    place(time, time);
    if (first) bodies.update_exemption(now);
    bodies.begin(now);
}

void ExplicitContact::shell_changed(const ShellChange& change) {
    bodies.shell_changed(change);
    if (sheets) sheets->surface_changed(change);
    look_everywhere();
}

void ExplicitContact::find_forces(const Substep& at_end, ContactForces& sum) {
    const bool any_deforms = std::ranges::any_of(
        options.obstacles, [](const Obstacle& obstacle) { return obstacle.deformation != nullptr; });
    sum.clear(at_end.position.cols(), followed, options.obstacles.size(),
              any_deforms ? sheets->surface().collider_vertices() : 0);
    add_obstacles(at_end, sum);
    bodies.add_forces(at_end, before, now, sum);
    if (options.sheets) add_crack_faces(at_end.position, sum);
    if (sheets) add_sheets(at_end, sum);
}

void ExplicitContact::add_obstacles(const Substep& at_end, ContactForces& sum) const {
    for (std::size_t o = 0; o < at_vertices.size(); ++o) {
        const double coefficient = options.obstacles[o].friction;
        at_vertices[o].add_springs(
            followed, at_end.position, now[o], Curvature::convex, [&](Index v, const PointForce& spring) {
                const Vector3d at = at_end.position.col(v), normal = spring.gradient.normalized();
                const Vector3d way =
                    at_end.velocity.col(v) - velocity_of_point(before[o], now[o], at, at_end.length);
                const Vector3d slip = way - normal * normal.dot(way);
                const Vector3d friction_force = explicit_friction(coefficient * spring.gradient.norm(), slip,
                                                                  shell.mass[v], at_end.length);
                sum.force.col(v) -= spring.gradient;
                sum.obstacles[o].add(at, -spring.gradient);
                sum.add_friction(v, friction_force);
                sum.add_friction(o, at, friction_force);
            });
    }
}

void ExplicitContact::add_crack_faces(const Positions& x, ContactForces& sum) const {
    for (const CrackFaceStencil& crack_face : everywhere ? shell.crack_faces : near_faces) {
        const PairPositions slope = gradient(crack_face, columns(x, crack_face.vertices));
        for (int v = 0; v < 4; ++v) sum.force.col(crack_face.vertices[v]) -= slope.col(v);
    }
}

void ExplicitContact::add_sheets(const Substep& at_end, ContactForces& sum) {
    if (!everywhere && pairs.empty()) return;
    const Positions& all = sheets->at_end(at_end.position);
    const Index first = sheets->surface().collider_vertices();
    if (everywhere) {
        active = sheets->active_pairs_of(all);
    } else {
        active.clear();
        std::ranges::copy_if(pairs, std::back_inserter(active), [&](const ContactPair& pair) {
            return within(pair.activation_distance, pair, columns(all, pair.vertices));
        });
    }
    threads.share_lots<PairPositions>(
        active.size(),
        [&](std::size_t i, PairPositions& contact_force) {
            contact_force = -gradient(active[i], columns(all, active[i].vertices));
        },
        [&](std::size_t i, std::span<const PairPositions> lot) {
            for (const PairPositions& contact_force : lot) {
                const std::array<Index, 4>& of_pair = active[i++].vertices;
                const Index least = *std::ranges::min_element(of_pair);
                for (int v = 0; v < 4; ++v) {
                    if (of_pair[v] < first) {
                        sum.add_collider_force(of_pair[v], contact_force.col(v));
                        continue;
                    }
                    sum.force.col(of_pair[v] - first) += contact_force.col(v);
                    if (least < first)
                        sum.obstacles[sheets->obstacle_number(least)].add(all.col(of_pair[v]),
                                                                          contact_force.col(v));
                }
            }
        });
    add_sheet_friction(at_end, all, sum);
}

PairPositions ExplicitContact::friction_of(const ContactPair& pair, const Substep& at_end,
                                           const Positions& all) const {
    const Index first = sheets->surface().collider_vertices();
    const Positions& colliders_before = sheets->colliders_at_start();
    PairPositions velocity;
    for (int i = 0; i < 4; ++i)
        velocity.col(i) =
            pair.vertices[i] < first
                ? Vector3d((all.col(pair.vertices[i]) - colliders_before.col(pair.vertices[i])) /
                           at_end.length)
                : Vector3d(at_end.velocity.col(pair.vertices[i] - first));
    const auto mobility = [&](const PairPositions& along) {
        double of_slip = 0;
        for (int i = 0; i < 4; ++i)
            if (pair.vertices[i] >= first)
                of_slip += along.col(i).squaredNorm() / shell.mass[pair.vertices[i] - first];
        return of_slip;
    };
    const ContactCollider* collider = sheets->surface().collider_of(pair.kind, pair.vertices);
    return pair_friction(pair, columns(all, pair.vertices), velocity,
                         collider ? collider->friction : options.friction, at_end.length, mobility);
}

void ExplicitContact::add_sheet_friction(const Substep& at_end, const Positions& all,
                                         ContactForces& sum) const {
    const Index first = sheets->surface().collider_vertices();
    threads.share_lots<PairPositions>(
        active.size(),
        [&](std::size_t i, PairPositions& friction_force) {
            friction_force = friction_of(active[i], at_end, all);
        },
        [&](std::size_t i, std::span<const PairPositions> lot) {
            for (const PairPositions& friction_force : lot) {
                const std::array<Index, 4>& of_pair = active[i++].vertices;
                const Index least = *std::ranges::min_element(of_pair);
                for (int v = 0; v < 4; ++v) {
                    if (of_pair[v] < first) {
                        sum.add_collider_friction(of_pair[v], friction_force.col(v));
                        continue;
                    }
                    sum.add_friction(of_pair[v] - first, friction_force.col(v));
                    if (least < first)
                        sum.add_friction(sheets->obstacle_number(least), all.col(of_pair[v]),
                                         friction_force.col(v));
                }
            }
        });
}

double ExplicitContact::stored_energy(const Positions& x) const {
    double sum = bodies.stored_energy(x, now);
    for (std::size_t o = 0; o < at_vertices.size(); ++o)
        at_vertices[o].add_springs(x, now[o], Curvature::convex,
                                   [&](Index, const PointForce& spring) { sum += spring.value; });
    if (sheets) sum += sheets->value(x);
    if (options.sheets) sum += crack_faces.value(x);
    return sum;
}

void ExplicitContact::look_everywhere() {
    everywhere = true;
    followed.resize(shell.mass.size());
    std::iota(followed.begin(), followed.end(), 0);
}

Positions ExplicitContact::motion_ahead(const StepContext& step) const {
    // Gravity is included: a sheet at rest that just touches another comes into contact within the step.
    Positions motion = margin_of_motion * step.length * step.velocity_origin;
    motion.colwise() += step.length * step.length * gravity;
    return motion;
}

ContactRates ExplicitContact::look_ahead(const StepContext& step) {
    everywhere = false;
    ContactRates sum{VectorXd::Zero(shell.mass.size())};
    const Positions motion = motion_ahead(step);
    const double way = motion.cols() > 0 ? std::sqrt(motion.colwise().squaredNorm().maxCoeff()) : 0;
    bodies.add_rates(step, way, margin_of_motion, sum);
    add_rates_of_obstacles(step, way, sum);
    pairs.clear();
    near_faces.clear();
    if (sheets) look_at_pairs(step, motion, sum);
    if (options.sheets) look_at_crack_faces(step, motion, sum);
    followed.clear();
    for (Index v = 0; v < static_cast<Index>(sum.of_vertices.size()); ++v)
        if (sum.of_vertices[v] > 0) followed.push_back(v);
    return sum;
}

void ExplicitContact::add_rates_of_obstacles(const StepContext& step, double way, ContactRates& sum) const {
    for (std::size_t o = 0; o < at_vertices.size(); ++o) {
        const Obstacle& obstacle = options.obstacles[o];
        VectorXd rates = VectorXd::Zero(sum.of_vertices.size());
        for (const double time : {step.begin, step.end()})
            if (time == step.begin || obstacle.moves())
                at_vertices[o].each_rate(step.origin, obstacle.motion.at(time), way,
                                         [&](Index v, double rate) { rates[v] = rate; });
        sum.of_vertices += rates;
    }
}

void ExplicitContact::look_at_pairs(const StepContext& step, const Positions& motion, ContactRates& sum) {
    sheets->begin(step);
    pairs = sheets->pairs_within_reach(step.origin, motion);
    const Positions all = sheets->at_start(step.origin);
    sheets->begin(substep);
    // Gershgorin's bound: the row sum of a pair's stiffness matrix at a vertex is the stiffness times the
    // vertex's weight in the closest points times two, the sum of all weights.
    const Index first = sheets->surface().collider_vertices();
    for (const ContactPair& pair : pairs) {
        const Closest closest = closest_points(pair.kind, columns(all, pair.vertices));
        for (int i = 0; i < 4; ++i)
            if (const Index v = pair.vertices[i] - first; v >= 0)
                sum.of_vertices[v] += 2 * std::max(least_weight, std::abs(closest.weights[i])) *
                                      pair.largest_stiffness() / shell.mass[v];
    }
}

void ExplicitContact::look_at_crack_faces(const StepContext& step, const Positions& motion,
                                          ContactRates& sum) {
    for (const CrackFaceStencil& crack_face : shell.crack_faces) {
        const PairPositions way = columns(motion, crack_face.vertices);
        const double farthest = (way.colwise() - way.rowwise().mean()).colwise().norm().maxCoeff();
        if (crack_face_opening(columns(step.origin, crack_face.vertices)) >= 2 * farthest) continue;
        near_faces.push_back(crack_face);
        for (const Index v : crack_face.vertices)
            sum.of_vertices[v] += 2 * crack_face.stiffness / shell.mass[v];
    }
}

double ExplicitContact::obstacle_work(std::span<const Reaction> forces, const Positions& on_deforming) const {
    double sum = 0;
    for (std::size_t o = 0; o < forces.size(); ++o)
        if (options.obstacles[o].moves() && options.obstacles[o].deformation == nullptr)
            sum += work(forces[o], before[o], now[o]);
    for (Index v = 0; v < static_cast<Index>(on_deforming.cols()); ++v)
        if (options.obstacles[sheets->obstacle_number(v)].deformation != nullptr)
            sum -= on_deforming.col(v).dot(sheets->collider_displacement(v));
    return sum;
}

bool ExplicitContact::end(const StepContext& step, const Positions& end_of_sheets) {
    bodies.update_exemption(now);
    if (options.barriers_follow && !allows_barriers(end_of_sheets))
        throw std::runtime_error(
            "contact: a sheet is pressed so deep into another one, an obstacle or a body that implicit steps "
            "could not continue from there: the springs of explicit contact are too weak; a stiffer or a "
            "thicker sheet, or less speed, may help");
    if (!passes(step, end_of_sheets)) {
        relax(end_of_sheets);
        return true;
    }
    if (!options.barriers_follow && stiffen_springs(step)) return false;
    refuse_passage();
}

void ExplicitContact::refuse_passage() {
    throw std::runtime_error(
        "contact: a sheet passes through another one, or an obstacle or a free body through a sheet: the "
        "springs of explicit contact are too weak; a stiffer or a thicker sheet, less speed, or implicit "
        "steps may help");
}

bool ExplicitContact::passes(const StepContext& step, const Positions& end) {
    if (bodies.pass_shell(step, end)) return true;
    if (!sheets) return false;
    sheets->begin(step);
    const bool passes = sheets->passes(step, step.origin, end);
    sheets->begin(substep);
    return passes;
}

bool ExplicitContact::allows_barriers(const Positions& end) const {
    return bodies.allow_barriers(end) && (!sheets || sheets->allows_barriers(end));
}

void ExplicitContact::set_second_spring(SecondSpring of_pairs) {
    second_spring = of_pairs;
    bodies.set_second_spring(second_spring);
    if (sheets) sheets->set_second_spring(second_spring);
}

bool ExplicitContact::stiffen_springs(const StepContext& step) {
    double least = bodies.least_share_at_start(step.origin);
    if (sheets) {
        sheets->begin(step);
        least = std::min(least, sheets->least_share_at_start(step.origin));
        sheets->begin(substep);
    }
    if (second_spring.degree == stiffest_second_spring) return false;
    SecondSpring stiffer{static_cast<std::uint8_t>(second_spring.degree + 1)};
    while (stiffer.share() > least && stiffer.halvings < most_halvings) ++stiffer.halvings;
    if (stiffer.share() > least) return false;
    set_second_spring(stiffer);
    return true;
}

void ExplicitContact::relax(const Positions& end) {
    if (second_spring.degree == 0) return;
    double least = bodies.least_share_at_end(end);
    if (sheets) least = std::min(least, sheets->least_share_at_end(end));
    if (least >= second_spring.share()) set_second_spring({});
}

Positions ExplicitContact::crack_face_forces(const Positions& x) const {
    Positions gradient = Positions::Zero(3, x.cols());
    if (options.sheets) crack_faces.add_gradient(x, gradient);
    return -gradient;
}

Touch ExplicitContact::touch(const Positions& x) const {
    Touch touch;
    std::set<const ColliderSurface*> surfaces;
    if (sheets) sheets->add_touched(x, touch.vertices, surfaces);
    for (std::size_t o = 0; o < at_vertices.size(); ++o) {
        Touch own;
        at_vertices[o].add_touch(x, now[o], own);
        touch.include_obstacle(o, own, surfaces.contains(options.obstacles[o].surface.get()));
    }
    bodies.add_touch(x, now, touch);
    return touch;
}

}  // namespace sherd
