// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <sstream>

#include "fracture/residual_stress.h"
#include "fracture/simulation.h"
#include "meshops/error.h"

// Interventions in a simulation between two steps, by its caller; simulation.cpp has the step.

namespace sherd {
namespace {

void require_hinges(const BreakableShell& shell, std::span<const Edge> edges) {
    for (auto edge = edges.begin(); edge != edges.end(); ++edge) {
        const bool is_repeated = std::find(edges.begin(), edge, *edge) != edge;
        if (shell.hinge_of_edge(*edge) >= 0 && !is_repeated) continue;
        std::ostringstream text;
        text << "the edge between the vertices " << shell.mesh().vertex(*edge, 0).idx() << " and "
             << shell.mesh().vertex(*edge, 1).idx() << " cannot fail: it "
             << (is_repeated ? "is given twice" : "has failed already, or is on the boundary");
        throw Error(text.str());
    }
}

/// Energy of residual stress, J, that the failure of these edges releases, one after the other.
double residual_released(const BreakableShell& shell, std::span<const Edge> edges) {
    std::vector<CrackPiece> pieces;
    double released = 0;
    for (const Edge edge : edges) {
        const Vertex first = shell.mesh().vertex(edge, 0), second = shell.mesh().vertex(edge, 1);
        const Positions& rest = shell.mechanics().rest;
        const CrackPiece piece{rest.col(static_cast<Index>(first)), rest.col(static_cast<Index>(second))};
        released += residual_release(shell, first, piece.to, pieces) * (piece.to - piece.from).norm();
        pieces.push_back(piece);
    }
    return released;
}

}  // namespace

void Simulation::give_forces(const Positions& forces) {
    if (!options.stepper.shell.given_forces)
        throw Error("the simulation was not made for given forces: ShellEnergyOptions::given_forces");
    if (const Eigen::Index count = breakable.mechanics().position.cols(); forces.cols() != count) {
        std::ostringstream text;
        text << "there are forces for " << forces.cols() << " vertices, and " << count << " vertices";
        throw Error(text.str());
    }
    stepper->give_forces(forces);
}

void Simulation::prescribe(std::span<const Index> vertices, const Positions& positions, double then) {
    const Shell& shell = breakable.mechanics();
    std::ostringstream text;
    if (!(then > time())) {
        text << "vertices cannot be at their place at " << then << ": it is " << time() << " already";
        throw Error(text.str());
    }
    for (const Index vertex : vertices) {
        if (vertex >= 0 && vertex < static_cast<Index>(shell.fixed.size()) && shell.fixed[vertex]) continue;
        text << "vertex " << vertex << " cannot go as it is told: no pin holds it in all directions";
        throw Error(text.str());
    }
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        const Vector3d rest = shell.rest.col(vertices[i]), from = shell.position.col(vertices[i]),
                       to = positions.col(static_cast<Eigen::Index>(i));
        Motion motion;
        motion.smooth = false;
        motion.keys = {{time(), from - rest}, {then, to - rest}};
        set_motion(vertices[i], motion);
    }
}

void Simulation::set_motion(Index vertex, const Motion& motion) {
    Shell& shell = breakable.mechanics();
    Index& script = shell.script[vertex];
    // Motions of the start may be shared with clamps, and those of a split vertex with its copies.
    const bool is_own = script > static_cast<Index>(scripts) && std::ranges::count(shell.script, script) == 1;
    if (!is_own) {
        shell.motions.emplace_back();
        script = static_cast<Index>(shell.motions.size());
    }
    shell.motions[script - 1] = motion;
}

void Simulation::break_by_hand(std::span<const Edge> edges) {
    require_hinges(breakable, edges);
    const HingeMeasures measures = measured().hinges;
    residual -= residual_released(breakable, edges);
    // A change of the shell needs an open step. The next begin() discards that step and books the energy that
    // is lost.
    stepper->begin(step_size.size());
    break_edges(edges, measures, 0);
    stepper->position = breakable.mechanics().position;
    update_fragments();
    set_time(events, steps, time());
}

}  // namespace sherd
