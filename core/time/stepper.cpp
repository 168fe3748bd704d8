// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/time/stepper.h"

#include "core/time/explicit_stepper.h"
#include "core/time/implicit_stepper.h"

namespace sherd {
namespace {

/// In statics weight is a load like others: it grows with the load factor.
Load weight_as_load(const Shell& shell, const Vector3d& gravity) {
    Load load;
    for (Index t = 0; t < static_cast<Index>(shell.triangles.size()); ++t)
        load.spread.push_back({t, shell.face_mass[t] * gravity});
    return load;
}

ShellEnergyOptions shell_options(const Shell& shell, const StepperOptions& options) {
    ShellEnergyOptions all = options.shell;
    if (options.scheme == Scheme::statics && !options.gravity.isZero(0))
        all.loads.push_back(weight_as_load(shell, options.gravity));
    // The explicit scheme itself computes this damping, from the change of the elastic forces.
    if (options.scheme == Scheme::explicit_differences) all.damping.stiffness = 0;
    return all;
}

std::unique_ptr<Stepper> stepper_of(Shell& shell, const StepperOptions& options, StepperStart start) {
    if (options.scheme == Scheme::explicit_differences)
        return std::make_unique<ExplicitStepper>(shell, options, std::move(start));
    return std::make_unique<ImplicitStepper>(shell, options, std::move(start));
}

}  // namespace

StepperStart stepper_start(const Shell& shell, const StepperOptions& options) {
    return {ShellEnergies(shell, shell_options(shell, options)), {options.contact.bodies}};
}

std::unique_ptr<Stepper> make_stepper(Shell& shell, const StepperOptions& options) {
    return stepper_of(shell, options, stepper_start(shell, options));
}

std::unique_ptr<Stepper> with_scheme(std::unique_ptr<Stepper> before, Scheme scheme, bool barriers_follow) {
    before->discard();
    StepperOptions options = before->options;
    options.scheme = scheme;
    options.contact.barriers_follow = barriers_follow;
    before->forces.damp(shell_options(before->shell, options));
    before->ledger.scheme_changed();
    return stepper_of(before->shell, options,
                      {std::move(before->forces),
                       {before->bodies(), before->crossed()},
                       before->ledger,
                       before->spent,
                       before->time});
}

Stepper::Stepper(Shell& shell, const StepperOptions& options, StepperStart& start)
    : position(shell.position),
      spent(start.spent),
      shell(shell),
      options(options),
      forces(std::move(start.forces)),
      ledger(start.ledger),
      time(start.time) {}

PotentialEnergies Stepper::energies() const {
    PotentialEnergies sum = elastic_energies();
    sum.gravity = -load() * options.gravity.dot(position * shell.mass);
    for (const RigidBody& body : bodies()) sum.gravity -= body.mass * options.gravity.dot(body.centre);
    return sum;
}

Positions Stepper::elastic_gradient() {
    Positions sum = Positions::Zero(3, position.cols());
    for (const Energy* energy : forces.elastic()) energy->add_gradient(position, sum);
    return sum;
}

void Stepper::place_clamps_at_start(StepContext step) {
    step.length = 0;
    for (Energy* energy : forces.elastic()) energy->begin(step);
}

double Stepper::elastic_at_start(const StepContext& step) {
    place_clamps_at_start(step);
    return forces.bending_value(shell.position) + forces.membrane_value(shell.position);
}

double Stepper::weight(const Positions& x) const {
    if (options.scheme == Scheme::statics) return 0;
    double sum = -options.gravity.dot(x * shell.mass);
    for (const RigidBody& body : bodies()) sum -= body.mass * options.gravity.dot(body.centre);
    return sum;
}

double Stepper::moving(const Positions& velocity, const Positions& x) const {
    if (options.scheme == Scheme::statics) return 0;
    double kinetic = kinetic_energy(shell.mass, velocity);
    for (const RigidBody& body : bodies()) kinetic += body.kinetic_energy();
    return kinetic + weight(x);
}

}  // namespace sherd
