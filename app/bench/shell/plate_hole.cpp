// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/bench/shell/plate_hole.h"

#include <algorithm>
#include <cmath>

#include "app/bench/shell/face_moments.h"
#include "app/bench/shell/rim_load.h"
#include "app/bench/shell/scene_snippets.h"
#include "app/bench/shell/shell_case.h"

namespace sherd {
namespace {

constexpr double hole_outer = 3;  // radius of the computed part of the plate
// Moments are compared with theory within this radius. Faces along the outer rim do not show the moment that
// loads the rim, since coupled hinges assume that a free side carries none.
constexpr double hole_seen = 2;
constexpr double hole_moment = 1e-4;  // so small that the theory is linear

}  // namespace

// The deflection is w = -r^2 / (4 (1 + nu)) + axial ln r + (-square r^2 + even + inverse / r^2) cos(2 angle),
// with constants for which there is no moment and no force on the rim: m_rr = 0 and q_r + d m_rt / (r d
// angle) = 0.
PlateHole::PlateHole(double poisson)
    : poisson(poisson),
      axial(-1 / (2 * (1 - poisson))),
      square(1 / (4 * (1 - poisson))),
      even(-2 * (1 - poisson) / (3 + poisson) * square),
      inverse((1 - poisson) / (3 + poisson) * square) {}

Eigen::Matrix2d PlateHole::moments(const Vector2d& p) const {
    const double r2 = p.squaredNorm(), r = std::sqrt(r2);
    const double cos2 = (p.x() * p.x() - p.y() * p.y()) / r2, sin2 = 2 * p.x() * p.y() / r2;
    const double plain = -1 / (2 * (1 + poisson)), b = even / r2, c = inverse / (r2 * r2);
    Eigen::Matrix2d second;  // second derivatives of w along the radius and across it
    second(0, 0) = plain - axial / r2 + (-2 * square + 6 * c) * cos2;
    second(1, 1) = plain + axial / r2 + (2 * square - 4 * b - 6 * c) * cos2;
    second(0, 1) = second(1, 0) = (2 * square + 2 * b + 6 * c) * sin2;
    Eigen::Matrix2d polar;
    polar << p / r, Vector2d(-p.y(), p.x()) / r;
    return -polar * ((1 - poisson) * second + poisson * second.trace() * Eigen::Matrix2d::Identity()) *
           polar.transpose();
}

// The shear force is minus the gradient of the Laplacian of w, -4 even cos(2 angle) / r^2 + constant.
Vector2d PlateHole::shear(const Vector2d& p) const {
    const double r2 = p.squaredNorm(), r = std::sqrt(r2);
    const double cos2 = (p.x() * p.x() - p.y() * p.y()) / r2, sin2 = 2 * p.x() * p.y() / r2;
    return -8 * even / (r2 * r) * (cos2 * p + sin2 * Vector2d(-p.y(), p.x())) / r;
}

double PlateHole::rim_moment() const {
    return (5 + 3 * poisson) / (3 + poisson);
}

namespace {

void add_hole_loads(const Shell& shell, SimulationOptions& options) {
    const PlateHole hole(plate_poisson);
    std::vector<char> at_rim(shell.mass.size());
    for (std::size_t v = 0; v < at_rim.size(); ++v)
        at_rim[v] = shell.rest.col(static_cast<Eigen::Index>(v)).norm() > hole_outer - 1e-9;
    Load load;
    for (const TriangleEdge& side : boundary_triangle_edges(shell, at_rim))
        add_rim_moments(shell, side, hole_moment * hole.moments(middle_of(shell, side)),
                        hole_moment * hole.shear(middle_of(shell, side)), load);
    options.stepper.shell.loads.push_back(load);
    options.fields.stress = true;
}

std::vector<ShellResult> measure_hole(const Simulation& simulation, const StepReport&) {
    const PlateHole hole(plate_poisson);
    const Shell& shell = simulation.shell().mechanics();
    const FaceFields fields = simulation.snapshot().fields;
    double at_rim = 0, exact_at_rim = 0;
    for (Index face = 0; face < static_cast<Index>(shell.triangles.size()); ++face) {
        const Vector2d middle = middle_of(shell, face);
        const auto on_rim = std::ranges::count_if(
            shell.triangles[face].vertices, [&](Index v) { return shell.rest.col(v).norm() < 1 + 1e-9; });
        if (on_rim < 2) continue;
        const Vector2d around = Vector2d(-middle.y(), middle.x()).normalized();
        const double exact = hole_moment * around.dot(hole.moments(middle) * around);
        at_rim += around.dot(face_moments(shell, fields, face, plate_thickness) * around) * exact;
        exact_at_rim += exact * exact;
    }
    const auto exact = [&](const Vector2d& p) -> Eigen::Matrix2d { return hole_moment * hole.moments(p); };
    return {{"moments, rms", moments_error(shell, fields, exact, plate_thickness, 1, hole_seen)},
            {"moment at the rim", hole.rim_moment() * at_rim / exact_at_rim, hole.rim_moment()}};
}

}  // namespace

ShellCase plate_hole_case() {
    return {.name = "plate with a hole, bent",
            .sheet = revolution(line(1, 0, hole_outer, 0), 90) + unit_plate() + planes_x_y +
                     "pin = { box = " + box_at({1, 0, 0}) + ", free = [\"x\", \"y\"] }\n",
            .rest = "",
            .step = 1,
            .edges = {0.08, 0.04, 0.02},
            .add_loads = add_hole_loads,
            .measure = measure_hole,
            .measured = "moments (rms), moment at the rim",
            .source =
                "Goodier 1936: moments of the faces within two radii of the hole's, those along its rim "
                "in the least squares; at three radii the exact moments and forces are the load; nu 0.3"};
}

}  // namespace sherd
