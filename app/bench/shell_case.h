// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string>
#include <vector>

namespace sherd {

/// A published number: what a gauge shows at a load factor.
struct ShellReference {
    double load;
    std::string gauge;
    int axis;  ///< 0, 1, 2: x, y, z of the displacement
    double value;
    std::string name;  ///< as published: "-U", "W_A"
};

/// A published number of a path with limit points: the load there, and what a gauge shows.
struct ShellLimit {
    double highest, at_highest;  ///< load factor; displacement
    double lowest, at_lowest;
};

/// A benchmark problem of thin shells.
struct ShellCase {
    std::string name;
    std::string sheet;   ///< TOML of the sheet without its mesh's edge_length and structured
    std::string rest;    ///< TOML of loads and gauges
    double step = 0.05;  ///< of load factor, or of path
    std::vector<ShellReference> references = {};
    std::vector<ShellLimit> limits =
        {};                       ///< at most one: it is followed by arc length, its gauge is the first
    std::array<double, 3> edges;  ///< coarse, medium, fine: length of edges
};

/// What a scene of the case says: its mesh, and how its hinges bend.
struct ShellVariant {
    double edge = 0;
    bool structured = false;
    std::string bending = "coupled";
    std::string membrane = {};  ///< empty: the default
};

/// The set of Sze, Liu, Lo, Popular benchmark problems for geometric nonlinear analysis of shells, Finite
/// Elements in Analysis and Design 40 (2004), without its laminates. Lengths and forces are in the paper's
/// units. Parts between planes of symmetry stand for the whole.
std::vector<ShellCase> sze_cases();

/// The scene of a case, as TOML.
std::string scene_text(const ShellCase& one, const ShellVariant& variant);

}  // namespace sherd
