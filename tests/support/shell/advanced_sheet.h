// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <rapidcheck/gtest.h>

#include "fracture/shell/breakable_shell.h"
#include "meshops/mesh_measures.h"
#include "tests/support/mesh/drawn_sheet.h"

namespace sherd::test {

/// Thickness, m: between 9 and 42 mm on the sheets of drawn_sheet().
inline double linear_thickness(const Eigen::Vector3d& at) {
    return 0.01 + 0.002 * at.x() + 0.003 * at.y() - 0.001 * at.z();
}

/// Sheet of drawn_sheet() with an orthotropic material and strength, and for odd seeds with uneven thickness.
inline SheetInput directed_input(unsigned shape, unsigned seed) {
    SheetInput input;
    input.mesh = drawn_sheet(shape, seed);
    input.material = {.density = 1000, .thickness = 0.01, .young = 1e9, .poisson = 0.3};
    input.material.young1 = 4e8;
    input.material.shear = 2e8;
    input.strength = {.measure = Measure::stress, .along = 2, .across = 1};
    Random random(seed + 5);
    for (const Face face : input.mesh.faces()) {
        const Eigen::Vector3d normal = triangle_normal(face_points(input.mesh, face)).normalized();
        const Eigen::Vector3d wanted(0.8, 0.1, 0.6);
        input.axes.push_back((wanted - normal * normal.dot(wanted)).normalized());
    }
    for (std::size_t e = 0; e < input.mesh.number_of_edges(); ++e)
        input.strength.factors.push_back(random.uniform(0.5, 1.5));
    if (seed % 2 == 0) return input;
    for (const Vertex v : input.mesh.vertices())
        input.thickness.push_back(linear_thickness(position(input.mesh, v)));
    return input;
}

/// Returns the sheet rebuilt from its present mesh and thickness. Edges of the sheet that have failed without
/// opening fail in the result, too.
inline BreakableShell rebuilt(const BreakableShell& sheet, SheetInput input) {
    input.mesh = sheet.mesh();
    input.axes.assign(sheet.axes().begin(), sheet.axes().end());
    input.strength.factors.clear();
    if (!input.thickness.empty())
        input.thickness.assign(sheet.mechanics().thickness.begin(), sheet.mechanics().thickness.end());
    std::vector<Edge> closed;
    for (const Edge edge : sheet.mesh().edges()) {
        input.strength.factors.push_back(sheet.strength_factor(edge));
        if (sheet.cracks().state(edge) == EdgeState::fractured_interior) closed.push_back(edge);
    }
    BreakableShell anew({input});
    if (!closed.empty()) anew.fail(closed);
    return anew;
}

/// Makes edges in a sheet at random, from crack tips or from any vertex, and lets edges fail.
class Advances {
  public:
    Advances(BreakableShell& sheet, unsigned seed) : sheet(sheet), random(seed) {}

    /// Makes an edge, which does not fail yet. Returns nothing if its direction points off the sheet.
    std::optional<BreakableShell::Advanced> next() {
        const Vertex tip = chosen_tip();
        Vector3d direction = random.matrix<Vector3d>(1);
        const Halfedge h = sheet.mesh().halfedge(tip);
        const Face face = sheet.mesh().face(sheet.mesh().is_border(h) ? sheet.mesh().opposite(h) : h);
        const Vector3d normal = triangle_normal(face_points(sheet.mesh(), face)).normalized();
        direction -= normal * normal.dot(direction);
        AdvanceOptions options;
        options.snap = random.below(4) > 0;
        return sheet.advance(tip, direction, options);
    }
    /// Lets the edge fail. Returns nothing if it has already failed or is on the boundary.
    std::optional<BreakableShell::Change> fail(Halfedge h) {
        const Edge edge = sheet.mesh().edge(h);
        if (sheet.cracks().state(edge) != EdgeState::interior) return std::nullopt;
        return sheet.fail(std::array{edge});
    }
    bool random_bool() { return random.below(2) == 0; }

  private:
    Vertex chosen_tip() {
        std::vector<Vertex> tips;
        for (const Vertex vertex : sheet.mesh().vertices())
            if (sheet.cracks().is_tip(vertex)) tips.push_back(vertex);
        if (!tips.empty() && random.below(3) > 0) return tips[random.below(tips.size())];
        return Vertex(random.below(sheet.mesh().number_of_vertices()));
    }

    BreakableShell& sheet;
    Random random;
};

}  // namespace sherd::test
