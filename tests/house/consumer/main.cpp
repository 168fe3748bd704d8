// SPDX-License-Identifier: GPL-3.0-or-later
// Calls each library of the package: makes a sheet, weighs it and cuts it along all its edges.
#include <cmath>
#include <cstdio>
#include <vector>

#include "fracture/shell/breakable_shell.h"
#include "meshops/generate/generate.h"
#include "meshops/topology/components.h"

int main() {
    sherd::GenerateOptions options;
    options.edge_length = 0.05;
    sherd::SheetInput input;
    input.mesh = sherd::generate_rectangle(0.2, 0.1, options);
    input.material.density = 2000;
    input.material.thickness = 0.01;
    input.material.young = 1e9;
    input.strength = sherd::uniform_strength(1);
    sherd::BreakableShell sheet({input});
    const double mass = sheet.mechanics().mass.sum();

    std::vector<sherd::Edge> interior;
    for (const sherd::Edge edge : sheet.mesh().edges())
        if (!sheet.mesh().is_border(edge)) interior.push_back(edge);
    sheet.fail(interior);
    const auto pieces = sherd::connected_components(sheet.mesh()).count;

    std::printf("%g kg, %d pieces\n", mass, pieces);
    const bool as_expected =
        std::abs(mass - 0.4) < 1e-12 && pieces == static_cast<int>(sheet.mesh().number_of_faces());
    return as_expected ? 0 : 1;
}
