// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <functional>
#include <string>
#include <vector>

#include "app/scene/scene.h"
#include "fracture/step/simulation.h"

namespace sherd {

/// A number that an experiment measures.
struct FractureNumber {
    std::string name;   ///< "K_I / theory"
    double theory = 1;  ///< expected value
    double bound = 0;   ///< largest allowed difference between the measured and the expected value
};

/// Record of a run.
struct FractureHistory {
    const Scene& scene;
    std::vector<StepReport> steps;
    CrackEvents events;
    Positions rest;  ///< [3, V] m, rest positions of the vertices at the end of the run
};

/// An experiment with a sheet that breaks or nearly breaks, which is compared with theory. It is a shipped
/// scene whose sheet is called "plate".
struct FractureCase {
    std::string name;
    std::string scene;            ///< name of the shipped scene
    std::string variant;          ///< variant of the scene; empty: none
    std::string source;           ///< source of the theory
    double unit;                  ///< m, unit of the lengths of edges in tables
    std::string in_units;         ///< symbol of this unit
    std::array<double, 3> edges;  ///< m, length of edges of the coarse, the medium and the fine meshes
    std::vector<FractureNumber> numbers;
    /// Returns the values of `numbers` in a run, or nothing if the run does not have them. If has_crack, only
    /// runs in which the crack grew are measured.
    std::function<std::vector<double>(const FractureHistory&)> measure;
    /// Replaces the loads of the scene by loads that no scene file can describe.
    std::function<void(const Scene&, const Shell&, SimulationOptions&)> replace_loads = {};
    bool compares_paths = false;  ///< whether the crack's path should be the same on all meshes
    bool has_crack = true;        ///< whether the sheet has a crack from the start, which should grow
};

std::vector<FractureCase> centre_cracks();
FractureCase edge_notch();
FractureCase bent_plate();
FractureCase double_cantilever();
FractureCase offset_hole();
FractureCase branching();
std::vector<FractureCase> released_strips();

/// Returns all these cases.
std::vector<FractureCase> fracture_cases();

}  // namespace sherd
