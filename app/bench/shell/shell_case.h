// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <functional>
#include <string>
#include <vector>

#include "fracture/step/simulation.h"

namespace sherd {

/// A known number: what a gauge shows at a load factor.
struct ShellReference {
    double load;
    std::string gauge;
    int axis;  ///< 0, 1, 2: x, y, z of the displacement
    double value;
    std::string name;  ///< as published: "-U", "W_A"
};

/// A known number of a path with limit points: the load there, and what a gauge shows.
struct ShellLimit {
    double highest, at_highest;  ///< load factor; displacement
    double lowest, at_lowest;
};

/// A computed number beside its reference.
struct ShellResult {
    std::string name;             ///< "W_A at 0.5"
    double value, reference = 0;  ///< without a reference the value is an error in itself

    double error() const { return 100 * (reference == 0 ? value : value / reference - 1); }  ///< %
};

/// A benchmark problem of thin plates or shells.
struct ShellCase {
    std::string name;
    std::string sheet;   ///< TOML of the sheet, with MESH for its mesh's edge_length and structured
    std::string rest;    ///< TOML of loads and gauges, and of further sheets
    double step = 0.05;  ///< step of the load factor, or of the path
    std::vector<ShellReference> references = {};
    std::vector<ShellLimit> limits =
        {};  ///< at most one: it is followed by arc length, its gauge is the first
    std::vector<double> frequencies = {};  ///< Hz, of the first modes; with these there are no loads
    std::array<double, 3> edges;           ///< coarse, medium, fine: length of edges
    bool has_structured = true;            ///< whether its shape has a structured mesh

    /// Adds what a scene cannot say: loads that vary from place to place.
    std::function<void(const Shell&, SimulationOptions&)> add_loads = {};
    /// Measures at the end what no gauge shows.
    std::function<std::vector<ShellResult>(const Simulation&, const StepReport&)> measure = {};
    std::string measured = {};  ///< names of what it measures
    std::string source = {};    ///< description and source of the references; empty: Sze, Liu, Lo
};

/// Measures the elastic energy of the last step beside this one, J.
std::function<std::vector<ShellResult>(const Simulation&, const StepReport&)> energy_beside(double reference);

/// A scene of the case: its mesh, and the bending model of its hinges.
struct ShellVariant {
    double edge = 0;
    bool structured = false;
    std::string bending = "coupled";
    std::string membrane = {};  ///< empty: the default

    std::string model() const { return bending + (membrane.empty() ? "" : "+" + membrane); }
};

/// model: BENDING or BENDING+MEMBRANE, as solver.bending and solver.membrane have them.
ShellVariant shell_variant(const std::string& model, double edge, bool structured);

/// The set of Sze, Liu, Lo, Popular benchmark problems for geometric nonlinear analysis of shells, Finite
/// Elements in Analysis and Design 40 (2004), without its laminates. Lengths and forces are in the paper's
/// units. Parts between planes of symmetry stand for the whole.
std::vector<ShellCase> sze_cases();

/// Plates, and a strip in large deflections, beside theory. They have the rigidity 1 and the side 1, or the
/// radius 1 of a hole.
std::vector<ShellCase> plate_cases();

/// A plate that is bent at infinity, with a hole in it: displacements, moments of faces, moment at the rim.
ShellCase plate_hole_case();

/// Hyperboloids that bend without stretching, to be computed with arcs where they are thin.
std::vector<ShellCase> hyperboloid_cases();

/// All of them.
std::vector<ShellCase> shell_cases();

/// The scene of a case, as TOML.
std::string scene_text(const ShellCase& one, const ShellVariant& variant);

}  // namespace sherd
