// SPDX-License-Identifier: GPL-3.0-or-later
// falling_square: a square of glass, made of plain arrays, falls on a corner and breaks.
#include <array>
#include <cstdio>
#include <memory>
#include <vector>

#include "core/contact/geometry/basic_shapes.h"
#include "fracture/step/simulation.h"
#include "meshops/repair/triangle_mesh.h"

int main() {
    constexpr int cells = 12;  // cells along each side, of 0.2 m
    std::vector<Eigen::Vector3d> positions;
    std::vector<std::array<std::int32_t, 3>> triangles;
    for (int i = 0; i <= cells; ++i)
        for (int j = 0; j <= cells; ++j) {
            const double x = 0.2 * i / cells, y = 0.2 * j / cells;
            positions.emplace_back(0.5 * (x + y), 0.7 * (x - y), 0.002 + 0.5 * (x + y));  // m, inclined
            const int a = i * (cells + 1) + j, b = a + cells + 1;
            if (i == cells || j == cells) continue;
            triangles.push_back({a, b, b + 1});
            triangles.push_back({a, b + 1, a + 1});
        }

    sherd::SheetInput glass;
    glass.mesh = sherd::triangle_mesh(positions, triangles);
    glass.material = {2500, 0.002, 7e10, 0.2};      // kg/m^3, m, Pa, Poisson's ratio
    glass.strength = sherd::uniform_strength(0.2);  // 1/m
    glass.velocity = {0, 0, -5};
    sherd::SimulationOptions options;
    options.stepper.step = 1e-4;
    sherd::Obstacle floor;
    floor.shape = std::make_shared<sherd::PlaneShape>(sherd::Vector3d::Zero(), sherd::Vector3d::UnitZ());
    options.stepper.contact.obstacles = {floor};
    sherd::Simulation simulation({glass}, options);
    sherd::StepReport report;
    while (simulation.time() < 0.01) report = simulation.step();
    std::printf("%g s: %d fragments\n", report.time, static_cast<int>(report.fragments));
}
