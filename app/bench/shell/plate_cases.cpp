// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <cmath>
#include <functional>
#include <numbers>

#include "app/bench/shell/face_moments.h"
#include "app/bench/shell/scene_snippets.h"
#include "app/bench/shell/shell_case.h"
#include "core/vector.h"

namespace sherd {
namespace {

using Vector4d = Eigen::Vector4d;

/// A point of a bent cantilever: angle, curvature, and position along and across the straight cantilever.
using State = Eigen::Vector4d;

/// The state of the tip under the load q of elastica_tip() for a given curvature at the wall, by the
/// Runge-Kutta method of fourth order.
State tip_state(double q, double curvature) {
    const auto slope = [&](double s, const State& y) {
        return State(y[1], -q * (1 - s) * std::cos(y[0]), std::cos(y[0]), std::sin(y[0]));
    };
    State y(0, curvature, 0, 0);
    constexpr int steps = 1000;
    constexpr double h = 1.0 / steps;
    for (int i = 0; i < steps; ++i) {
        const double s = i * h;
        const State a = slope(s, y), b = slope(s + h / 2, y + h / 2 * a), c = slope(s + h / 2, y + h / 2 * b),
                    d = slope(s + h, y + h * c);
        y += h / 6 * (a + 2 * b + 2 * c + d);
    }
    return y;
}

/// Displacement of the tip of an inextensible cantilever of length 1 and rigidity 1 under the dead load q per
/// length, which acts across the straight cantilever: along the cantilever towards the wall, and in the
/// direction of the load. Solves angle'' = -q (1 - s) cos(angle), angle(0) = 0, angle'(1) = 0, to ten digits.
Vector2d elastica_tip(double q) {
    double low = 0, high = q;
    for (int i = 0; i < 60; ++i) {
        const double middle = 0.5 * (low + high);
        (tip_state(q, middle)[1] < 0 ? low : high) = middle;
    }
    const State tip = tip_state(q, low);
    return {1 - tip[2], tip[3]};
}

constexpr double pi = std::numbers::pi;

/// A square plate with free sides. The list has values of omega a^2 sqrt(rho t / D): converged Ritz values,
/// up to 0.9 % below the upper bounds of Leissa, J. Sound Vib. 31 (1973), 257-293
/// (13.489, 19.789, 24.432, 35.024, 35.024, 61.526).
ShellCase free_square() {
    std::vector<double> frequencies;
    for (const double omega : {13.468, 19.596, 24.270, 34.801, 34.801, 61.093})
        frequencies.push_back(omega / std::sqrt(plate_thickness) / (2 * pi));
    return {.name = "plate, free square, frequencies",
            .sheet = rectangle(1, 1) + unit_plate(),
            .rest = "",
            .frequencies = frequencies,
            .edges = {0.05, 0.025, 0.0125},
            .source = "Leissa 1973, with the digits of converged Ritz values; nu 0.3"};
}

/// Deflection of the middle of a supported square under the pressure q, over q a^4 / D, by Navier's series.
double navier() {
    double sum = 0;
    for (int m = 1; m < 200; m += 2)
        for (int n = 1; n < 200; n += 2)
            sum +=
                ((m + n) / 2 % 2 == 0 ? -1 : 1) * 16 / std::pow(pi, 6) / (m * n * std::pow(m * m + n * n, 2));
    return sum;
}

/// A quarter of a square of side 1 about the origin under pressure. support: key for the sides, `pin` or
/// `clamp`; factor: deflection of the middle over q a^4 / D.
ShellCase pressed_square(const std::string& name, const std::string& support, double factor,
                         const std::string& source) {
    const std::string sides =
        fmt::format("{0} = [{{ box = {1} }}, {{ box = {2} }}]\n", support, box({0.499999, -1, -1}, {1, 1, 1}),
                    box({-1, 0.499999, -1}, {1, 1, 1}));
    return {.name = "plate, " + name + " square under pressure",
            .sheet = rectangle(0.5, 0.5) + unit_plate() + planes_x_y + sides,
            .rest = fmt::format("[[force.load]]\npressure = {}\n", small) + gauge_at("middle", {0, 0, 0}),
            .step = 1,
            .references = {{1, "middle", 2, small * factor, "middle"}},
            .edges = {0.05, 0.025, 0.0125},
            .source = source};
}

/// Compliance S11 of a strip at an angle to the first material axis, times Young's modulus along this axis.
/// young1, shear: moduli over this modulus; Poisson's ratios are 0.
double compliance(double degrees, double young1, double shear) {
    const double w = degrees * pi / 180, c = std::pow(std::cos(w), 2), s = std::pow(std::sin(w), 2);
    return c * c + s * s / young1 + s * c / shear;
}

/// TOML of a separate strip at the place `y`, without its mesh. It is held at three corners, so that the
/// moments at its two ends are the only load on it, and its curvature is the same everywhere. young1, shear:
/// see compliance().
std::string bent_strip(const std::string& name, double y, double degrees, double young1, double shear) {
    const double young = young_of_unit_plate(0);
    return fmt::format(
               "place = {{ translate = [0, {}, 0] }}\n"
               "material = {{ density = 1, thickness = {}, young = [{}, {}], poisson = 0, shear = {}, "
               "axis = {{ degrees = {} }} }}\n"
               "pin = [{{ box = {} }}, {{ box = {}, free = [\"x\"] }}, {{ box = {}, free = [\"x\", \"y\"] "
               "}}]\n",
               y, plate_thickness, young, young1 * young, shear * young, degrees, box_at({0, y, 0}),
               box_at({1, y, 0}), box_at({0, y + 0.25, 0})) +
           fmt::format(
               "[[force.load]]\nsheet = \"{0}\"\nmoment = {1}\nbox = {2}\n"
               "[[force.load]]\nsheet = \"{0}\"\nmoment = {1}\nbox = {3}\n",
               name, 0.1 * small, box({-1, -1, -1}, {1e-6, 100, 1}), box({0.999999, -1, -1}, {2, 100, 1})) +
           gauge_at(name, {0.5, y, 0});
}

ShellCase orthotropic_strips() {
    constexpr double young1 = 0.2, shear = 0.16;  // Y1 / Y0 and G01 / Y0
    ShellCase all{.name = "plate, orthotropic strips",
                  .sheet = "",
                  .rest = "",
                  .step = 1,
                  .edges = {0.1, 0.05, 0.025},
                  .source =
                      "1/S11 of strips at angles to the first axis, in pure bending between free sides; "
                      "Y1 = 0.2 Y0, G01 = 0.16 Y0, Poisson's ratios 0"};
    for (int i = 0; i <= 6; ++i) {
        const int degrees = 15 * i;
        const std::string name = i == 0 ? "shell" : fmt::format("strip{}", degrees);
        const std::string mesh = rectangle(1, 0.25);
        (i == 0 ? all.sheet : all.rest) += (i == 0 ? "" : fmt::format("[sheet.{}]\n", name)) + mesh +
                                           bent_strip(name, i, degrees, young1, shear);
        all.references.push_back({1, name, 2, 0.1 * small / 8 * compliance(degrees, young1, shear),
                                  fmt::format("{} degrees", degrees)});
    }
    return all;
}

ShellCase heavy_elastica() {
    const Vector2d tip = elastica_tip(8);
    return {.name = "strip, heavy elastica",
            .sheet = rectangle(1, 0.25) + unit_plate(0) + clamp_at_y_axis,
            .rest = "[[force.load]]\narea = [0, 0, -8]\n" + gauge_at("tip", {1, 0.125, 0}),
            .step = 0.1,
            .references = {{1, "tip", 0, -tip.x(), "-U"}, {1, "tip", 2, -tip.y(), "-W"}},
            .edges = {0.1, 0.05, 0.025},
            .source = "the elastica's equation; q L^3 / D = 8, nu 0"};
}

/// A strip that is held at three corners. The force P at the fourth corner makes forces of the size P at all
/// four: m_xy is P / 2 everywhere.
ShellCase twisted_strip() {
    constexpr double width = 0.25, force = 0.1 * small;
    return {.name = "plate, twisted strip",
            .sheet = rectangle(1, width) + unit_plate() +
                     fmt::format("pin = [{{ box = {} }}, {{ box = {}, free = [\"x\"] }}, "
                                 "{{ box = {}, free = [\"x\", \"y\"] }}]\n",
                                 box_at({0, 0, 0}), box_at({1, 0, 0}), box_at({0, width, 0})),
            .rest = force_at({1, width, 0}, {0, 0, force}) + gauge_at("corner", {1, width, 0}),
            .step = 1,
            .references = {{1, "corner", 2, force * width / (2 * (1 - plate_poisson)), "corner"}},
            .edges = {0.1, 0.05, 0.025},
            .source = "forces at the corners, w = P x y / (2 D (1 - nu)); nu 0.3"};
}

constexpr double ring_inner = 0.4;

/// A ring of rigidity 1 and radii `ring_inner` and 1 that is clamped at both rims, under a pressure of 1.
class ClampedRing {
  public:
    ClampedRing();
    double energy() const;  ///< elastic energy: half the work of the pressure
    /// Moments in the form of PlateMoments, for a pressure that pushes towards z > 0.
    Eigen::Matrix2d moments(const Vector2d& p) const;

  private:
    Vector4d found;  ///< a, b, c, d in the deflection w = r^4 / 64 + a + b r^2 + c ln r + d r^2 ln r
};

ClampedRing::ClampedRing() {
    const auto shapes = [](double r) { return Vector4d(1, r * r, std::log(r), r * r * std::log(r)); };
    const auto slopes = [](double r) { return Vector4d(0, 2 * r, 1 / r, 2 * r * std::log(r) + r); };
    Eigen::Matrix4d rims;
    rims << shapes(ring_inner).transpose(), slopes(ring_inner).transpose(), shapes(1).transpose(),
        slopes(1).transpose();
    const double r3 = std::pow(ring_inner, 3);
    found = -rims.inverse() * Vector4d(r3 * ring_inner / 64, r3 / 16, 1.0 / 64, 1.0 / 16);
}

double ClampedRing::energy() const {
    constexpr int pieces = 1000;
    double work = 0;
    for (int i = 0; i < pieces; ++i) {  // midpoint rule
        const double r = ring_inner + (1 - ring_inner) * (i + 0.5) / pieces, r2 = r * r;
        const double w = r2 * r2 / 64 + found.dot(Vector4d(1, r2, std::log(r), r2 * std::log(r)));
        work += 2 * pi * r * w * (1 - ring_inner) / pieces;
    }
    return work / 2;
}

Eigen::Matrix2d ClampedRing::moments(const Vector2d& p) const {
    const double r2 = p.squaredNorm(), log = std::log(r2) / 2;
    const double along = 3 * r2 / 16 + found.dot(Vector4d(0, 2, -1 / r2, 2 * log + 3));  // w''
    const double around = r2 / 16 + found.dot(Vector4d(0, 2, 1 / r2, 2 * log + 1));      // w' / r
    const Eigen::Matrix2d radial = p * p.transpose() / r2;
    const Eigen::Matrix2d second = around * Eigen::Matrix2d::Identity() + (along - around) * radial;
    return -((1 - plate_poisson) * second + plate_poisson * second.trace() * Eigen::Matrix2d::Identity());
}

/// The relative error of the moments of faces away from the rims.
std::vector<ShellResult> measure_ring(const ClampedRing& ring, const Simulation& simulation,
                                      const StepReport&) {
    const Shell& shell = simulation.shell().mechanics();
    const double push = small * side_of(shell, 0);  // pressure pushes along the normals of faces
    const auto exact = [&](const Vector2d& p) -> Eigen::Matrix2d { return push * ring.moments(p); };
    return {{"moments, rms",
             moments_error(shell, simulation.snapshot().fields, exact, plate_thickness, 0.5, 0.9)}};
}

ShellCase clamped_ring() {
    return {
        .name = "plate, clamped ring under pressure",
        .sheet = revolution(line(ring_inner, 0, 1, 0), 360) + unit_plate() + "clamp = { boundary = true }\n",
        .rest = fmt::format("[[force.load]]\npressure = {}\n", small),
        .step = 1,
        .edges = {0.06, 0.03, 0.015},
        .has_structured = false,
        .measure = energy_beside(small * small * ClampedRing().energy()),
        .measured = "energy",
        .source = "radii 0.4 and 1, the plate's equation; nu 0.3"};
}

ShellCase moments_of_ring() {
    ShellCase ring = clamped_ring();
    ring.name = "plate, moments of the clamped ring";
    ring.add_loads = [](const Shell&, SimulationOptions& options) { options.fields.stress = true; };
    ring.measure = std::bind_front(measure_ring, ClampedRing());
    ring.measured = "moments of faces between the radii 0.5 and 0.9 (rms)";
    return ring;
}

}  // namespace

std::vector<ShellCase> plate_cases() {
    return {free_square(),
            pressed_square("supported", "pin", navier(), "Navier's series; nu 0.3"),
            pressed_square("clamped", "clamp", 0.00126532, "0.00126532 q a^4 / D (Timoshenko); nu 0.3"),
            orthotropic_strips(),
            heavy_elastica(),
            twisted_strip(),
            clamped_ring(),
            moments_of_ring()};
}

}  // namespace sherd
