// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string>
#include <vector>

#include "app/bench/cost/race.h"
#include "app/bench/cost/solver_choice.h"

namespace sherd {

/// A scene of the experiment that repeats figure 2 of the paper Cubic Shells. Steps are measured in the
/// middle of its motion.
struct PaperScene {
    std::string name;
    std::string scene;                  ///< name of the shipped scene
    std::string sheet;                  ///< name of the sheet in this scene
    double area;                        ///< m^2, area of the sheet
    std::array<double, 5> steps;        ///< s, sizes of steps, ascending
    double begin;                       ///< s, time of the scene from which on steps are measured
    std::vector<std::string> settings;  ///< KEY=VALUE, changes of the shipped scene
};

/// Returns the three scenes: an orthotropic flag in the wind, a cylinder and a bowl that fall.
std::vector<PaperScene> paper_scenes();

/// A measurement: a scene, a size of steps and a mesh.
struct PaperCase {
    PaperScene scene;
    double step;  ///< s, size of steps
    int side;     ///< the mesh has about side^2 vertices
    int laps;     ///< number of steps that are measured
};

/// Returns the measurements for the figure: for each scene five sizes of steps on one mesh, and the middle
/// size on four more meshes. If `quick`, three sizes of steps on a coarser mesh, and the middle size on one
/// more mesh. Leaves out meshes of more than `most_vertices` vertices.
std::vector<PaperCase> paper_cases(bool quick, double most_vertices);

/// Result of one solver choice in one case.
struct PaperResult {
    RaceResult race;
    /// StepCost::rate() over that of the choice with which this one is compared (SolverChoice::beside). 0 if
    /// it is unknown.
    double ratio = 0;
    /// Largest distance at the end, in lengths of an edge, between a vertex and the same vertex in the run
    /// with the first choice of the same energies. NaN if the runs made different steps or did not finish.
    double difference = 0;
};

/// Simulates the scene to the time PaperScene::begin with the energies of the first choice, the default
/// method and the largest step, then lets all choices race from this state. Returns a result for each choice.
std::vector<PaperResult> run_paper_case(const PaperCase& one, const std::vector<SolverChoice>& choices);

}  // namespace sherd
