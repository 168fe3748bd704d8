// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <functional>
#include <string>
#include <vector>

#include "fracture/step/simulation.h"

namespace sherd {

/// Known displacement of a gauge at a load factor.
struct ShellReference {
    double load;        ///< load factor
    std::string gauge;  ///< name of the gauge
    int axis;           ///< 0, 1, 2: x, y, z of the displacement
    double value;
    std::string name;  ///< name of the displacement in the source: "-U", "W_A"
};

/// Known limit points of a path of load over displacement.
struct ShellLimit {
    double highest, at_highest;  ///< load factor at the upper limit point, displacement of the gauge there
    double lowest, at_lowest;    ///< load factor at the lower limit point, displacement of the gauge there
};

/// A computed number and its reference.
struct ShellResult {
    std::string name;             ///< "W_A at 0.5"
    double value, reference = 0;  ///< reference 0: there is none, and the value is itself a relative error

    double error() const { return 100 * (reference == 0 ? value : value / reference - 1); }  ///< %
};

/// A benchmark problem of thin plates or shells.
struct ShellCase {
    std::string name;
    std::string sheet;   ///< TOML of the sheet, with MESH in place of its mesh's edge_length and structured
    std::string rest;    ///< TOML of loads and gauges, and of further sheets
    double step = 0.05;  ///< step of the load factor or, with `limits`, of the length of the path
    std::vector<ShellReference> references = {};
    std::vector<ShellLimit> limits =
        {};  ///< none or one; with one, the path is followed by arc length, and gauge 0 is compared
    std::vector<double> frequencies = {};  ///< Hz, of the first modes; if any, modes are computed, not steps
    std::array<double, 3> edges;           ///< length of edges of the coarse, the medium and the fine mesh
    bool has_structured = true;            ///< whether the shape of the sheet has a structured mesh

    /// Adds loads that no scene file can describe since they vary from place to place, and fields that
    /// `measure` needs.
    std::function<void(const Shell&, SimulationOptions&)> add_loads = {};
    /// Returns results at the end of the run that no gauge shows.
    std::function<std::vector<ShellResult>(const Simulation&, const StepReport&)> measure = {};
    std::string measured = {};  ///< names of the results of `measure`
    std::string source = {};    ///< description and source of the references; empty: those of sze_cases()
};

/// Returns a ShellCase::measure: the elastic energy at the end of the last step, J, beside this reference.
std::function<std::vector<ShellResult>(const Simulation&, const StepReport&)> energy_beside(double reference);

/// A mesh and the models of bending and stretching, with which a case is computed.
struct ShellVariant {
    double edge = 0;                  ///< length of the mesh's edges
    bool structured = false;          ///< whether the mesh is structured
    std::string bending = "coupled";  ///< solver.bending
    std::string membrane = {};        ///< solver.membrane; empty: the default

    std::string model() const { return bending + (membrane.empty() ? "" : "+" + membrane); }
};

/// Returns a variant. model: BENDING or BENDING+MEMBRANE, values of solver.bending and solver.membrane.
ShellVariant shell_variant(const std::string& model, double edge, bool structured);

/// The problems of Sze, Liu, Lo, Popular benchmark problems for geometric nonlinear analysis of shells,
/// Finite Elements in Analysis and Design 40 (2004), without its laminates. Lengths and forces are in the
/// units of this publication. Where there are planes of symmetry, only the part between them is computed.
std::vector<ShellCase> sze_cases();

/// Plates, and a strip in large deflections, with references from theory. Their rigidity is 1, and their
/// longer side or outer radius is 1.
std::vector<ShellCase> plate_cases();

/// A part of an infinite bent plate with a hole: moments of the faces, and moment at the rim of the hole.
ShellCase plate_hole_case();

/// Hyperboloids of three thicknesses that bend almost without stretching. The thin ones need `+arc`.
std::vector<ShellCase> hyperboloid_cases();

/// Returns the cases of all these functions.
std::vector<ShellCase> shell_cases();

/// The scene of a case with a variant's mesh and models, as TOML.
std::string scene_text(const ShellCase& one, const ShellVariant& variant);

}  // namespace sherd
