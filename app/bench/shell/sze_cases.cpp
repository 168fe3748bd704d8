// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "app/bench/shell/scene_snippets.h"
#include "app/bench/shell/shell_case.h"

namespace sherd {
namespace {

ShellCase end_shear() {
    return {.name = "cantilever, end shear",
            .sheet = rectangle(10, 1) + material(0.1, 1.2e6, 0) + clamp_at_y_axis,
            .rest = "[[force.load]]\nline = [0, 0, 4]\nbox = [[9.99999, -1, -1], [11, 2, 1]]\n" +
                    gauge_at("tip", {10, 0.5, 0}),
            .references = {{0.4, "tip", 0, -1.184, "-U"},
                           {0.4, "tip", 2, 4.292, "W"},
                           {1, "tip", 0, -3.286, "-U"},
                           {1, "tip", 2, 6.698, "W"}},
            .edges = {0.5, 0.25, 0.125}};
}

/// Only half of the width is computed, up to a plane of symmetry: a whole strip under moments of constant
/// direction would buckle sideways before it is bent to a ring.
ShellCase end_moment() {
    return {.name = "cantilever, end moment",
            .sheet = rectangle(12, 0.5) + material(0.1, 1.2e6, 0) + clamp_at_y_axis +
                     "symmetry = { point = [0, 0, 0], normal = [0, 1, 0] }\n",
            .rest = fmt::format("[[force.load]]\nmoment = {}\nbox = [[11.99999, -1, -1], [13, 2, 1]]\n",
                                -50 * std::numbers::pi / 3) +
                    gauge_at("tip", {12, 0.25, 0}),
            .references = {{0.25, "tip", 0, -4.361, "-U"},
                           {0.25, "tip", 2, 7.639, "W"},
                           {0.5, "tip", 0, -12, "-U"},
                           {0.5, "tip", 2, 7.639, "W"},
                           {1, "tip", 0, -12, "-U"}},
            .edges = {0.5, 0.25, 0.125}};
}

ShellCase slit_annulus() {
    constexpr double degrees = 359.99;
    const double last = degrees * std::numbers::pi / 180;
    const auto on_slit = [&](double r) { return Vector3d(r * std::cos(last), r * std::sin(last), 0); };
    return {.name = "slit annular plate",
            .sheet = revolution(line(6, 0, 10, 0), degrees) + material(0.03, 21e6, 0) +
                     "clamp = { box = [[5, -1e-6, -1], [11, 1e-6, 1]] }\n",
            .rest = "[[force.load]]\nline = [0, 0, 0.8]\nbox = [[5, -0.01, -1], [11, -1e-4, 1]]\n" +
                    gauge_at("A", on_slit(6)) + gauge_at("B", on_slit(10)),
            .references = {{0.1, "A", 2, 4.277, "W_A"},
                           {0.1, "B", 2, 5.876, "W_B"},
                           {0.5, "A", 2, 10.468, "W_A"},
                           {0.5, "B", 2, 13.768, "W_B"},
                           {1, "A", 2, 13.891, "W_A"},
                           {1, "B", 2, 17.528, "W_B"}},
            .edges = {1, 0.5, 0.25}};
}

ShellCase hemisphere() {
    return {.name = "hemisphere with a hole",
            .sheet = revolution(arc(10, 18, 90), 90) + material(0.04, 6.825e7, 0.3) + planes_x_y +
                     "pin = { box = " + box_at({10, 0, 0}) + ", free = [\"x\", \"y\"] }\n",
            .rest = force_at({10, 0, 0}, {200, 0, 0}) + force_at({0, 10, 0}, {0, -200, 0}) +
                    gauge_at("A", {10, 0, 0}) + gauge_at("B", {0, 10, 0}),
            .references = {{0.1, "A", 0, 1.499, "U_A"},
                           {0.1, "B", 1, -1.840, "-V_B"},
                           {0.25, "A", 0, 2.596, "U_A"},
                           {0.25, "B", 1, -3.833, "-V_B"},
                           {0.5, "A", 0, 3.406, "U_A"},
                           {0.5, "B", 1, -5.902, "-V_B"},
                           {1, "A", 0, 4.067, "U_A"},
                           {1, "B", 1, -8.178, "-V_B"}},
            .edges = {1.6, 0.8, 0.4}};
}

ShellCase pull_out() {
    constexpr double r = 4.953, half = 10.35 / 2;
    return {.name = "cylinder, pulled",
            .sheet = revolution(line(r, half, r, 0), 90) + material(0.094, 10.5e6, 0.3125) + planes_x_y_z,
            .rest = force_at({r, 0, 0}, {10000, 0, 0}) + gauge_at("A", {r, 0, 0}) + gauge_at("B", {0, r, 0}) +
                    gauge_at("C", {0, r, half}),
            .references = {{0.1, "A", 0, 1.707, "W_A"},
                           {0.1, "B", 1, -2.217, "-U_B"},
                           {0.1, "C", 1, -2.293, "-U_C"},
                           {0.5, "A", 0, 2.473, "W_A"},
                           {0.5, "B", 1, -3.653, "-U_B"},
                           {0.5, "C", 1, -3.718, "-U_C"},
                           {1, "A", 0, 2.768, "W_A"},
                           {1, "B", 1, -4.551, "-U_B"},
                           {1, "C", 1, -3.269, "-U_C"}},
            .edges = {0.6, 0.3, 0.15}};
}

ShellCase pinched() {
    return {.name = "cylinder with diaphragms, pinched",
            .sheet = revolution(line(100, 100, 100, 0), 90) + material(1, 3e4, 0.3) + planes_x_y_z +
                     "pin = { box = [[-1, -1, 99.9999], [101, 101, 101]], free = [\"z\"] }\n",
            .rest = force_at({100, 0, 0}, {-3000, 0, 0}) + gauge_at("A", {100, 0, 0}) +
                    gauge_at("B", {0, 100, 0}),
            .references = {{0.1, "A", 0, -23.164, "-W_A"},
                           {0.1, "B", 1, -2.391, "U_B"},
                           {0.5, "A", 0, -73.790, "-W_A"},
                           {0.5, "B", 1, 25.381, "U_B"},
                           {1, "A", 0, -83.102, "-W_A"},
                           {1, "B", 1, 34.272, "U_B"}},
            .edges = {8, 4, 2}};
}

ShellCase semi_cylinder() {
    return {.name = "semi-cylinder, pinched",
            .sheet = revolution(line(101.6, 304.8, 101.6, 0), 90) + material(3, 2068.5, 0.3) + planes_x_y +
                     "clamp = { box = [[-1, -1, -1], [102, 102, 1e-6]] }\n",
            .rest = force_at({0, 101.6, 304.8}, {0, -1000, 0}) + gauge_at("A", {0, 101.6, 304.8}),
            .references = {{0.25, "A", 1, -48.537, "-W"}, {1, "A", 1, -171.505, "-W"}},
            .edges = {20, 10, 5}};
}

ShellCase hinged_roof(double thickness, const ShellLimit& limit) {
    return {.name = fmt::format("hinged roof, h = {}", thickness),
            .sheet = revolution(line(2540, 254, 2540, 0), 0.1 * 180 / std::numbers::pi) +
                     material(thickness, 3102.75, 0.3) +
                     "pin = { box = [[0, 253, -1], [2540, 255, 300]] }\n"
                     "symmetry = [{ point = [0, 0, 0], normal = [0, 1, 0] }, "
                     "{ point = [0, 0, 0], normal = [0, 0, 1] }]\n",
            .rest = force_at({2540, 0, 0}, {-750, 0, 0}) + gauge_at("middle", {2540, 0, 0}),
            .limits = {limit},
            .edges = {64, 32, 16}};
}

}  // namespace

std::vector<ShellCase> sze_cases() {
    return {end_shear(),
            end_moment(),
            slit_annulus(),
            hemisphere(),
            pull_out(),
            pinched(),
            semi_cylinder(),
            hinged_roof(12.7, {0.7421, -11.293, 0.1729, -19.852}),
            hinged_roof(6.35, {0.1953, -12.892, -0.1288, -15.778})};
}

}  // namespace sherd
