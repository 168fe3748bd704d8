// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <cmath>

#include "app/bench/shell/scene_snippets.h"
#include "app/bench/shell/shell_case.h"

namespace sherd {
namespace {

/// Profile of the hyperboloid r^2 = 1 + z^2 from its end z = 1 to its waist z = 0, as TOML.
std::string hyperbola() {
    constexpr int pieces = 200;
    std::string points;
    for (int i = 0; i <= pieces; ++i) {
        const double z = 1 - static_cast<double>(i) / pieces;
        points += fmt::format("{}[{}, {}]", i == 0 ? "" : ", ", std::sqrt(1 + z * z), z);
    }
    return "[" + points + "]";
}

/// Dead forces of the outward pressure p cos(2 angle), with the angle about the z axis from the x axis.
Load periodic_pressure(const Shell& shell, double p) {
    Load load;
    for (Index face = 0; face < static_cast<Index>(shell.triangles.size()); ++face) {
        const auto& [a, b, c] = shell.triangles[face].vertices;
        const Vector3d corner = shell.rest.col(a);
        Vector3d area = (shell.rest.col(b) - corner).cross(shell.rest.col(c) - corner) / 2;
        const Vector3d middle = (corner + shell.rest.col(b) + shell.rest.col(c)) / 3;
        const double x2 = middle.x() * middle.x(), y2 = middle.y() * middle.y();
        if (area.head<2>().dot(middle.head<2>()) < 0) area = -area;
        for (int i = 0; i < 3; ++i) load.dead.push_back({face, i, p * (x2 - y2) / (x2 + y2) / 3 * area});
    }
    return load;
}

/// An eighth of the hyperboloid |z| < 1 with free ends and the thickness t. The pressure 1e4 t^3 cos(2 angle)
/// is multiplied by 0.1 t, so that the linear theory holds. energy: reference for the elastic energy of the
/// whole hyperboloid under the pressure without this factor, divided by t^3.
ShellCase hyperboloid(double thickness, double energy) {
    const double share = 0.1 * thickness, cube = std::pow(thickness, 3);
    return {.name = fmt::format("hyperboloid, free ends, t = {}", thickness),
            .sheet = revolution(hyperbola(), 90) + material(thickness, 2.85e4, 0.3) + planes_x_y_z,
            .rest = "",
            .step = 1,
            .edges = {0.2, 0.1, 0.05},
            .add_loads =
                [=](const Shell& shell, SimulationOptions& options) {
                    options.stepper.shell.loads.push_back(periodic_pressure(shell, share * 1e4 * cube));
                },
            .measure = energy_beside(energy * cube * share * share / 8),
            .measured = "energy",
            .source =
                "Koiter's shell in a Fourier and Legendre series (tests/app/hyperboloid_reference.py); E "
                "2.85e4, nu 0.3, pressure cos(2 angle)"};
}

}  // namespace

std::vector<ShellCase> hyperboloid_cases() {
    return {hyperboloid(0.1, 4498.0429), hyperboloid(0.01, 2601.7290), hyperboloid(0.001, 2580.0769)};
}

}  // namespace sherd
