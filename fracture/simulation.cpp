// SPDX-License-Identifier: GPL-3.0-or-later
#include "fracture/simulation.h"

#include <utility>

#include "fracture/breaking.h"
#include "fracture/opening_strain.h"

namespace sherd {
namespace {

/// Enough between two stages: the strains that matter next are those around the edges that just failed.
constexpr int iterations_between_stages = 3;

double mean_edge_length(const Sheet& sheet) {
    double sum = 0;
    for (const TriangleStencil& triangle : sheet.triangles)
        for (int i = 0; i < 3; ++i)
            sum += (sheet.rest.col(triangle.vertices[i]) - sheet.rest.col(triangle.vertices[(i + 1) % 3]))
                       .norm();
    return sum / (3.0 * static_cast<double>(sheet.triangles.size()));
}

TimeStepOptions time_step_options(const SimulationOptions& options, const Sheet& sheet) {
    TimeStepOptions result;
    result.step = options.step;
    result.gravity = options.gravity;
    result.planes = options.planes;
    result.bending = options.bending;
    result.newton.tolerance = options.tolerance * mean_edge_length(sheet);
    return result;
}

double largest(const VectorXd& strains) {
    return strains.size() == 0 ? 0 : strains.maxCoeff();
}

}  // namespace

Simulation::Simulation(const std::vector<SheetInput>& inputs, const SimulationOptions& options)
    : options(options),
      breakable(inputs),
      time_step(breakable.mechanics(), time_step_options(options, breakable.mechanics())),
      fragments(connected_components(breakable.mesh())) {}

StepReport Simulation::step() {
    StepReport report;
    report.step = ++steps;
    report.time = time();
    report.step_size = options.step;

    time_step.begin();
    NewtonResult newton = solve_stage(report, options.max_iterations);
    VectorXd strains = opening_strains(breakable, time_step.position);
    report.peak_strain = largest(strains);
    for (;;) {
        const std::vector<Edge> failing = failing_edges(breakable, strains, options.crack_tip_factor);
        report.stage_cap_reached = !failing.empty() && report.stages == options.max_stages;
        if (!failing.empty() && !report.stage_cap_reached) {
            break_edges(failing, strains, report.stages++);
            newton = solve_stage(report, iterations_between_stages);
        } else if (!newton.converged && newton.iterations == iterations_between_stages) {
            newton = solve_stage(report, options.max_iterations);
        } else {
            break;
        }
        strains = opening_strains(breakable, time_step.position);
    }
    report.converged = newton.converged;
    finish(report);
    return report;
}

NewtonResult Simulation::solve_stage(StepReport& report, int max_iterations) {
    const NewtonResult result = time_step.solve(max_iterations);
    report.newton_iterations += result.iterations;
    return result;
}

void Simulation::break_edges(std::span<const Edge> edges, const VectorXd& strains, Index stage) {
    record_failures(edges, strains, stage);
    const CrackMesh::Change change = breakable.fail(edges);
    record_change(change);
    time_step.position.conservativeResize(3, breakable.mechanics().position.cols());
    for (const auto& [vertex, created] : change.opening.vertices)
        time_step.position.col(created) = time_step.position.col(vertex);
    time_step.stencils_changed();
}

void Simulation::record_failures(std::span<const Edge> edges, const VectorXd& strains, Index stage) {
    const Mesh& mesh = breakable.mesh();
    for (const Edge edge : edges) {
        EdgeFailure failure;
        failure.time = time();
        failure.step = steps;
        failure.stage = stage;
        failure.edge = static_cast<Index>(edge);
        failure.vertices = {static_cast<Index>(mesh.vertex(edge, 0)),
                            static_cast<Index>(mesh.vertex(edge, 1))};
        failure.strain = strains[breakable.hinge_of_edge(edge)];
        events.failures.push_back(failure);
    }
}

void Simulation::record_change(const CrackMesh::Change& change) {
    const std::size_t first = events.failures.size() - change.boundary_vertices.size();
    for (std::size_t i = 0; i < change.boundary_vertices.size(); ++i)
        events.failures[first + i].boundary_vertices = change.boundary_vertices[i];
    for (const auto& [edge, created] : change.opening.edges)
        events.openings.push_back({time(), steps, static_cast<Index>(edge), static_cast<Index>(created)});
    for (const auto& [vertex, created] : change.opening.vertices)
        events.splits.push_back({time(), steps, static_cast<Index>(vertex), static_cast<Index>(created)});
}

void Simulation::finish(StepReport& report) {
    time_step.finish();
    if (report.stages > 0) fragments = connected_components(breakable.mesh());
    const PotentialEnergies potential = time_step.energies();
    report.kinetic = kinetic_energy(breakable.mechanics());
    report.bending = potential.bending;
    report.membrane = potential.membrane;
    report.gravity = potential.gravity;
    report.contact = potential.contact;
    report.linear_momentum = linear_momentum(breakable.mechanics());
    report.angular_momentum = angular_momentum(breakable.mechanics());
    report.contacts = time_step.contacts();
    report.fragments = fragments.count;
}

Snapshot Simulation::snapshot() const {
    Snapshot snapshot = take_snapshot(breakable, fragments.of_face);
    snapshot.step = steps;
    snapshot.time = time();
    return snapshot;
}

CrackEvents Simulation::take_events() {
    return std::exchange(events, {});
}

}  // namespace sherd
