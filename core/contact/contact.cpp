// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/contact/contact.h"

#include <algorithm>

namespace sherd {

Contact::Contact(const Shell& shell, ContactOptions given, const ContactStart& start, const Vector3d& gravity,
                 const Threads& threads)
    : shell(shell), options(std::move(given)), crack_faces(shell.crack_faces) {
    const std::vector<Obstacle>& obstacles = options.obstacles;
    if (!start.bodies.empty())
        body_contact = std::make_unique<BodyContact>(shell, start.bodies, obstacles, gravity, start.crossed);
    for (const Obstacle& obstacle : obstacles)
        obstacle_contact.push_back(
            std::make_unique<ObstacleContact>(shell, obstacle, obstacle_contact.size()));
    const bool surfaces = std::any_of(obstacles.begin(), obstacles.end(),
                                      [](const Obstacle& obstacle) { return obstacle.surface != nullptr; });
    if (!options.sheets && !surfaces) return;
    sheet_contact = std::make_unique<SheetContact>(shell, obstacles, options.sheets, false, threads);
    sheet_friction = std::make_unique<SheetFriction>(shell, *sheet_contact, options.friction);
}

std::vector<Energy*> Contact::energies() {
    std::vector<Energy*> all;
    if (body_contact) all.push_back(body_contact.get());
    for (const auto& contact : obstacle_contact) all.push_back(contact.get());
    if (sheet_contact) all.push_back(sheet_contact.get());
    if (options.sheets) all.push_back(&crack_faces);
    return all;
}

std::vector<double> Contact::body_masses() const {
    std::vector<double> masses;
    for (const RigidBody& body : bodies()) masses.push_back(body.mass);
    return masses;
}

std::vector<Energy*> Contact::frictions() {
    if (!sheet_friction) return {};
    return {sheet_friction.get()};
}

std::optional<std::string> Contact::overlap() const {
    return sheet_contact ? sheet_contact->overlap(shell.position) : std::nullopt;
}

double Contact::free_fraction(const Positions& motion) const {
    double fraction = sheet_contact ? sheet_contact->safe_fraction_of_step(shell.position, motion) : 1;
    if (!body_contact) return fraction;
    if (body_contact->blocked()) return 0;
    const Positions from = body_contact->with_bodies(shell.position);
    Positions all = Positions::Zero(3, from.cols());
    all.leftCols(motion.cols()) = motion;
    return std::min(fraction, body_contact->safe_fraction(from, all));
}

Positions Contact::push_displacement() const {
    if (!sheet_contact) return Positions::Zero(3, shell.position.cols());
    return sheet_contact->push_displacement(shell.position);
}

void Contact::place_bodies(const Positions& unknowns) {
    if (body_contact) body_contact->place(unknowns.rightCols(body_contact->place().cols()));
}

void Contact::predict_bodies(const Positions& x) {
    if (body_contact) body_contact->predict(x);
}

void Contact::add_gradient(const Positions& x, Positions& gradient) {
    if (body_contact) {
        const Positions all = with_bodies(x);
        Positions of_all = Positions::Zero(3, all.cols());
        body_contact->add_gradient(all, of_all);
        gradient += of_all.leftCols(x.cols());
    }
    for (const std::vector<Energy*>& some : {energies(), frictions()})
        for (const Energy* energy : some)
            if (!energy->has_bodies()) energy->add_gradient(x, gradient);
}

void Contact::end_step() {
    if (body_contact) body_contact->end_step();
}

bool Contact::passes(const StepContext& step, const Positions& x) const {
    return (sheet_contact && sheet_contact->passes(step, shell.position, x)) ||
           (body_contact && body_contact->passes(step, x));
}

void Contact::finish(const Positions& x) {
    if (body_contact) body_contact->finish(x);
    for (const auto& contact : obstacle_contact) contact->finish(x);
    if (sheet_friction) sheet_friction->finish(x);
}

const std::vector<RigidBody>& Contact::bodies() const {
    return body_contact ? body_contact->bodies() : options.bodies;
}

std::vector<char> Contact::crossed() const {
    return body_contact ? body_contact->crossed() : std::vector<char>{};
}

double Contact::stored_energy(const Positions& x) const {
    double sum = 0;
    for (const auto& contact : obstacle_contact) sum += contact->stored_energy(x);
    if (body_contact) sum += body_contact->stored_energy(x);
    if (sheet_contact) sum += sheet_contact->value(x);
    if (options.sheets) sum += crack_faces.value(x);
    return sum;
}

double Contact::stored_at_start() const {
    double sum = 0;
    for (const auto& contact : obstacle_contact) sum += contact->stored_at_start();
    if (body_contact) sum += body_contact->stored_at_start();
    if (sheet_contact) sum += sheet_contact->stored_at_start();
    if (options.sheets) sum += crack_faces.value(shell.position);
    return sum;
}

double Contact::friction_loss(const Positions& x) const {
    double sum = 0;
    for (const auto& contact : obstacle_contact) sum += contact->friction_loss(x);
    if (body_contact) sum += body_contact->friction_loss(x);
    if (sheet_friction) sum += sheet_friction->friction_loss(x);
    return sum;
}

double Contact::obstacle_work(const StepContext& step, const Positions& x) const {
    const std::vector<Obstacle>& obstacles = options.obstacles;
    if (std::ranges::none_of(obstacles, [](const Obstacle& obstacle) { return obstacle.moves(); })) return 0;
    const std::vector<Reaction> all = reactions(x);
    double sum = 0;
    for (std::size_t o = 0; o < all.size(); ++o)
        if (obstacles[o].moves() && obstacles[o].deformation == nullptr)
            sum += work(all[o], obstacles[o].motion.at(step.begin), obstacles[o].motion.at(step.end()));
    if (body_contact) sum += body_contact->work_of_deforming();
    if (sheet_contact) sum += sheet_contact->work_of_deforming(x);
    if (sheet_friction) sum += sheet_friction->work_of_deforming(x);
    return sum;
}

std::vector<Reaction> Contact::reactions(const Positions& x) const {
    std::vector<Reaction> all(options.obstacles.size());
    for (std::size_t o = 0; o < all.size(); ++o) obstacle_contact[o]->add_reaction(x, all[o]);
    if (body_contact) body_contact->add_reactions(all);
    if (sheet_contact) sheet_contact->add_reactions(x, all);
    if (sheet_friction) sheet_friction->add_reactions(x, all);
    return all;
}

Positions Contact::crack_face_forces(const Positions& x) const {
    Positions gradient = Positions::Zero(3, x.cols());
    if (options.sheets) crack_faces.add_gradient(x, gradient);
    return -gradient;
}

Touch Contact::touch(const Positions& x) const {
    Touch touch;
    std::set<const ColliderSurface*> surfaces;
    if (sheet_contact) sheet_contact->add_touched(x, touch.vertices, surfaces);
    for (std::size_t o = 0; o < obstacle_contact.size(); ++o) {
        Touch own;
        obstacle_contact[o]->add_touch(x, own);
        touch.include_obstacle(o, own, surfaces.contains(options.obstacles[o].surface.get()));
    }
    if (body_contact) body_contact->add_touch(x, touch);
    return touch;
}

}  // namespace sherd
