// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string>
#include <vector>

#include "app/bench/cost/race.h"
#include "app/bench/cost/solver_choice.h"

namespace sherd {

/// A scene of the experiment of the paper's figure 2. It is measured in the midst of what happens.
struct PaperScene {
    std::string name;
    std::string scene;                  ///< name of the shipped one
    std::string sheet;                  ///< name of its sheet
    double area;                        ///< m^2, of it
    std::array<double, 5> steps;        ///< s, ascending
    double begin;                       ///< s, from when on it is measured
    std::vector<std::string> settings;  ///< KEY=VALUE, other than the scene's
};

/// Orthotropic flags, falling cylinders, falling bowl.
std::vector<PaperScene> paper_scenes();

/// A measurement: a scene, a step and a mesh.
struct PaperCase {
    PaperScene scene;
    double step;  ///< s
    int side;     ///< the mesh has about as many vertices as a grid with this many a side
    int laps;     ///< steps that are measured
};

/// Measurements of the paper's figure: for each scene five steps on one mesh, and five meshes with the middle
/// step.
/// quick: fewer and smaller ones; most_vertices: of the largest mesh.
std::vector<PaperCase> paper_cases(bool quick, double most_vertices);

/// How one choice did in one case.
struct PaperResult {
    RaceResult race;
    double ratio = 0;  ///< simulated time per second over that of the choice compared with; 0: unknown
    /// Mean lengths of edges, the largest distance of a vertex from where it is with the first choice of the
    /// same energies; NaN where steps are not the same, or one of both has not finished.
    double difference = 0;
};

/// Races the choices, from a state that the default solver gets to with the first one's energies and the
/// largest step.
std::vector<PaperResult> run_paper_case(const PaperCase& one, const std::vector<SolverChoice>& choices);

}  // namespace sherd
