// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <functional>
#include <string>
#include <vector>

#include "app/scene/scene.h"
#include "fracture/step/simulation.h"

namespace sherd {

/// A number of an experiment.
struct FractureNumber {
    std::string name;   ///< "K_I / theory"
    double theory = 1;  ///< expected value
    double bound = 0;   ///< by which it may be off
};

/// All that has come of a run.
struct FractureHistory {
    const Scene& scene;
    std::vector<StepReport> steps;
    CrackEvents events;
    Positions rest;  ///< [3, V] m, in the end
};

/// A sheet that breaks, or nearly does, beside theory: a shipped scene whose sheet is called "plate".
struct FractureCase {
    std::string name;
    std::string scene;    ///< name of the shipped one
    std::string variant;  ///< empty: it has none
    std::string source;   ///< source of the theory
    double unit;          ///< m, in which tables have the length of edges
    std::string in_units;
    std::array<double, 3> edges;  ///< m: coarse, medium, fine
    std::vector<FractureNumber> numbers;
    /// The numbers of a run, in which a crack grew if there was one.
    std::function<std::vector<double>(const FractureHistory&)> measure;
    /// Puts what a scene cannot say into the place of its loads.
    std::function<void(const Scene&, const Shell&, SimulationOptions&)> replace_loads = {};
    bool compares_paths = false;  ///< whether all meshes should have the same path
    bool has_crack = true;        ///< from the start, which grows
};

std::vector<FractureCase> centre_cracks();
FractureCase edge_notch();
FractureCase bent_plate();
FractureCase double_cantilever();
FractureCase offset_hole();
FractureCase branching();
std::vector<FractureCase> released_strips();

/// All of them.
std::vector<FractureCase> fracture_cases();

}  // namespace sherd
