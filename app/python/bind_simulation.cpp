// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <algorithm>

#include "app/python/arrays.h"
#include "app/python/bindings.h"
#include "app/python/live_run.h"
#include "app/python/tables.h"
#include "app/python/without_lock.h"
#include "app/run/obstacle_track.h"
#include "app/scene/assemble/sheet/supports.h"
#include "app/scene/read/parts/fields.h"
#include "meshops/error.h"

namespace sherd::python {
namespace {

FaceFieldChoice choice_of(const std::vector<std::string>& names) {
    for (const std::string& name : names)
        if (std::ranges::find(field_names, name) == field_names.end())
            throw Error(fmt::format("fields: there is no field '{}'; known are \"{}\"", name,
                                    fmt::join(field_names, "\", \"")));
    return chosen_fields(names);
}

/// Returns force and moment of each support and obstacle at the end of the last step, by its name.
py::dict reactions(LiveRun& run) {
    py::dict by_name;
    const std::optional<StepReport>& report = run.report();
    if (!report) return by_name;
    const auto names = support_names(run.scene());
    for (std::size_t i = 0; i < names.size(); ++i)
        by_name[names[i].name.c_str()] =
            py::make_tuple(value_of(report->reactions[i].force), value_of(report->reactions[i].moment));
    return by_name;
}

/// Returns the pose of each obstacle and body at the simulation's time, by its name.
py::dict current_poses(LiveRun& run) {
    const Simulation& simulation = run.simulation();
    const std::vector<Obstacle>& obstacles = simulation.obstacles();
    const std::vector<RigidBody>& bodies = simulation.bodies();
    py::dict by_name;
    for (std::size_t i = 0; i < obstacles.size(); ++i)
        by_name[run.scene().obstacles[i].name.c_str()] = array_of(pose_of(obstacles[i], simulation.time()));
    for (std::size_t i = 0; i < bodies.size(); ++i)
        by_name[run.scene().bodies[i].name.c_str()] = array_of(bodies[i].pose());
    return by_name;
}

const Shell& shell_of(LiveRun& run) {
    return run.simulation().shell().mechanics();
}

void prescribe(LiveRun& run, const Numbers& vertices, const Numbers& positions, double time) {
    const std::vector<Index> told = indices_of(vertices, "vertices");
    run.changed().prescribe(told, columns_of(positions, "positions", static_cast<Eigen::Index>(told.size())),
                            time);
}

void set_forces(LiveRun& run, const std::optional<Numbers>& forces) {
    const Eigen::Index count = shell_of(run).position.cols();
    run.changed().give_forces(forces ? columns_of(*forces, "forces", count) : Positions::Zero(3, count));
}

}  // namespace

void bind_simulation(py::module_& module) {
    py::class_<LiveRun>(module, "Simulation", "A scene that is stepped.")
        .def(py::init<const Scene&, int>(), py::arg("scene"), py::arg("threads"),
             py::call_guard<WithoutLock>())
        .def(
            "step",
            [](LiveRun& run) {
                run.step();
                return *run.report();
            },
            "step() -> StepReport\n"
            "\n"
            "Makes one time step and returns its StepReport. Other Python threads run meanwhile. The\n"
            "step is shorter than Scene.step when it had to be halved. Raises Error when it cannot be\n"
            "solved.")
        .def(
            "snapshot",
            [](LiveRun& run, const std::vector<std::string>& fields) {
                return run.simulation().snapshot(choice_of(fields));
            },
            py::arg("fields") = std::vector<std::string>(),
            "snapshot(fields=[]) -> Snapshot\n"
            "\n"
            "Returns a Snapshot of the sheets as they are now, which later steps do not change. fields:\n"
            "fields of faces that it has, of \"stress\", \"curvature\" and \"membrane_strain\".")
        .def_property_readonly("scene", &LiveRun::scene, "The Scene that is simulated.")
        .def_property_readonly("warnings", &LiveRun::warnings, "Warnings about the scene, as sentences.")
        .def_property_readonly("has_ended", &LiveRun::has_ended,
                               "Whether the scene's duration, or the end of statics, has been reached.")
        .def_property_readonly(
            "has_arrived", [](LiveRun& run) { return run.simulation().arrived(); },
            "Whether no step is left, at the end of statics.")
        .def_property_readonly(
            "time", [](LiveRun& run) { return run.simulation().time(); },
            "Simulated time, s, or in Scene.time_unit.")
        .def_property_readonly(
            "report", [](LiveRun& run) { return std::optional<StepReport>(run.report()); },
            "StepReport of the last step; None before.")
        .def_property_readonly(
            "reactions", &reactions,
            "Force [3] N and moment [3] N m about the origin, on the sheets, of each support and\n"
            "obstacle at the end of the last step, by name: \"sheet.plate.pin\".")
        .def_property_readonly(
            "poses", &current_poses,
            "Matrices [4, 4] from the own frame of each obstacle and body to space, by name, as\n"
            "in Recording.poses.")
        .def_property_readonly(
            "positions", [](LiveRun& run) { return array_of(shell_of(run).position); },
            "[V, 3] m, a copy. Vertices are those of the sheets in the order of the scene; copies\n"
            "that cracks make follow them.")
        .def_property_readonly(
            "velocities", [](LiveRun& run) { return array_of(shell_of(run).velocity); },
            "[V, 3] m/s, a copy.")
        .def_property_readonly(
            "masses", [](LiveRun& run) { return array_of(shell_of(run).mass); }, "[V] kg, a copy.")
        .def_property_readonly(
            "faces", [](LiveRun& run) { return array_of(corners_of(shell_of(run))); },
            "[F, 3] vertices of each face, a copy.")
        .def_property_readonly(
            "pinned",
            [](LiveRun& run) {
                const std::vector<char>& fixed = shell_of(run).fixed;
                return array_of(std::vector<std::uint8_t>(fixed.begin(), fixed.end())).attr("astype")("bool");
            },
            "[V] whether a pin holds the vertex in all directions, a copy.")
        .def("set_forces", &set_forces, py::arg("forces").none(true),
             "set_forces(forces)\n"
             "\n"
             "Sets forces, [V, 3] N, that act on the vertices from the next step on, in addition to the\n"
             "scene's loads, until others are set; None removes them. Where a crack splits a vertex its\n"
             "copies share the force by mass; in statics it grows with the load factor. Raises Error on\n"
             "another shape, or a number that is not finite.")
        .def("prescribe", &prescribe, py::arg("vertices"), py::arg("positions"), py::arg("time"),
             "prescribe(vertices, positions, time)\n"
             "\n"
             "Moves pinned vertices [n] straight and at constant speed to positions [n, 3] m, which they\n"
             "reach at `time` (s) and keep. Raises Error when one of them is not pinned, or the time has\n"
             "passed.")
        .def(
            "break_edges",
            [](LiveRun& run, const Numbers& edges) {
                Simulation& simulation = run.changed();
                simulation.break_by_hand(edges_of(simulation.shell().mesh(), edges));
            },
            py::arg("edges"),
            "break_edges(edges)\n"
            "\n"
            "Makes the hinges of edges fail between two steps, whatever their strength, and opens the\n"
            "mesh where that separates it. Each edge is given by its two vertices, [n, 2]. The events\n"
            "come with the next step. Raises Error when an edge is not inside a sheet, has failed, or is\n"
            "given twice.")
        .def_property_readonly(
            "events", [](LiveRun& run) { return events_by_kind(run.events()); },
            "Events so far: for each kind (failure, opening, split, fragment, vertex_birth,\n"
            "face_birth, tips) its columns as arrays, by name, as in a recording.")
        .def("_record", &LiveRun::record, py::arg("file"), py::arg("force"))
        .def("_end_recording", &LiveRun::end_recording, py::arg("failure"));
}

}  // namespace sherd::python
