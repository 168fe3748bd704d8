// SPDX-License-Identifier: GPL-3.0-or-later
#include "fracture/step/interventions.h"

#include <algorithm>
#include <sstream>

#include "meshops/error.h"

namespace sherd {
namespace {

/// Sets the prescribed motion of one vertex. shared: see prescribe().
void set_motion(Shell& shell, std::size_t shared, Index vertex, const Motion& motion) {
    Index& script = shell.script[vertex];
    // A split vertex shares its motion with its copies.
    const bool is_own = script > static_cast<Index>(shared) && std::ranges::count(shell.script, script) == 1;
    if (!is_own) {
        shell.motions.emplace_back();
        script = static_cast<Index>(shell.motions.size());
    }
    shell.motions[script - 1] = motion;
}

}  // namespace

void require_forces(const ShellEnergyOptions& options, const Shell& shell, const Positions& forces) {
    if (!options.given_forces)
        throw Error("the simulation does not accept given forces; set ShellEnergyOptions::given_forces");
    if (const Eigen::Index count = shell.position.cols(); forces.cols() != count) {
        std::ostringstream text;
        text << "forces were given for " << forces.cols() << " vertices, but the sheets have " << count
             << " vertices";
        throw Error(text.str());
    }
}

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

void prescribe(Shell& shell, std::size_t shared, std::span<const Index> vertices, const Positions& positions,
               double now, double then) {
    std::ostringstream text;
    if (!(then > now)) {
        text << "vertices cannot reach their positions at " << then << ": the time is " << now << " already";
        throw Error(text.str());
    }
    for (const Index vertex : vertices) {
        if (vertex >= 0 && vertex < static_cast<Index>(shell.fixed.size()) && shell.fixed[vertex]) continue;
        text << "vertex " << vertex
             << " cannot follow prescribed positions: no pin holds it in all directions";
        throw Error(text.str());
    }
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        const Vector3d rest = shell.rest.col(vertices[i]), from = shell.position.col(vertices[i]),
                       to = positions.col(static_cast<Eigen::Index>(i));
        Motion motion;
        motion.smooth = false;
        motion.keys = {{now, from - rest}, {then, to - rest}};
        set_motion(shell, shared, vertices[i], motion);
    }
}

}  // namespace sherd
