// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "app/measures/fragments/fragment_distance.h"
#include "app/measures/measures.h"
#include "app/playback/frame_parents.h"
#include "app/python/bindings.h"
#include "app/python/tables.h"
#include "app/recording/recording.h"

namespace sherd::python {
namespace {

/// Returns the index of a frame; a negative `number` counts from the end.
std::size_t number_of(const Recording& recording, py::ssize_t number) {
    const auto count = static_cast<py::ssize_t>(recording.frame_count());
    if (number < -count || number >= count)
        throw py::index_error(fmt::format("frame {} of {}", number, count));
    return static_cast<std::size_t>(number < 0 ? number + count : number);
}

py::array times(const Recording& recording) {
    std::vector<double> all(recording.frame_count());
    for (std::size_t i = 0; i < all.size(); ++i) all[i] = recording.time(i);
    return array_of(all);
}

/// Returns force and moment of each support and obstacle in each step, by its name.
py::dict recorded_reactions(const Recording& recording) {
    const std::vector<RecordedSupport> supports = recording.header().supports;
    const std::vector<StepReport> steps = recording.steps();
    py::dict by_name;
    for (std::size_t i = 0; i < supports.size(); ++i) {
        std::vector<Reaction> rows;
        for (const StepReport& step : steps) rows.push_back(step.reactions[i]);
        by_name[supports[i].name.c_str()] = columns_by_name(rows);
    }
    return by_name;
}

/// Returns the recorded readings of each gauge in each step, by its name.
py::dict recorded_gauges(const Recording& recording) {
    const std::vector<RecordedGauge> gauges = recording.header().gauges;
    const std::vector<StepReport> steps = recording.steps();
    py::dict by_name;
    for (std::size_t i = 0; i < gauges.size(); ++i) {
        std::vector<GaugeReading> rows;
        for (const StepReport& step : steps) rows.push_back(step.gauges[i]);
        const py::dict all = columns_by_name(rows);
        py::dict recorded;
        for (const auto& [name, column] : all)
            if (recording_format::is_recorded(gauges[i], name.cast<std::string>())) recorded[name] = column;
        by_name[gauges[i].name.c_str()] = recorded;
    }
    return by_name;
}

/// Returns the poses of each obstacle and body in a frame, by its name.
py::dict poses(const Recording& recording, py::ssize_t frame) {
    const std::vector<RecordedObstacle> obstacles = recording.obstacles();
    const std::vector<Eigen::Isometry3d> places = recording.poses(number_of(recording, frame));
    py::dict by_name;
    for (std::size_t i = 0; i < obstacles.size(); ++i)
        by_name[obstacles[i].name.c_str()] = array_of(places[i]);
    return by_name;
}

CrackCentre centre_of(const std::variant<std::array<double, 3>, std::string>& about,
                      const std::vector<double>& radii) {
    CrackCentre centre{.radii = radii};
    if (const auto* point = std::get_if<std::array<double, 3>>(&about))
        centre.point = Vector3d(point->data());
    else
        centre.obstacle = std::get<std::string>(about);
    return centre;
}

py::tuple parents(const Recording& recording, py::ssize_t earlier, py::ssize_t later) {
    const FrameParents found = frame_parents(recording.frame(number_of(recording, earlier)),
                                             recording.frame(number_of(recording, later)));
    return py::make_tuple(array_of(found.faces), array_of(found.vertices), array_of(found.weights));
}

}  // namespace

void bind_recording(py::module_& module) {
    py::class_<Recording>(
        module, "Recording",
        "Recording(file): a recording that `sherd run` or sherd.record() has written, or is writing.\n"
        "Raises Error when it cannot be read. Each attribute is read from the file when it is\n"
        "accessed.")
        .def(py::init<const std::filesystem::path&>(), py::arg("file"))
        .def("__len__", &Recording::frame_count)
        .def(
            "frame",
            [](const Recording& recording, py::ssize_t number) {
                return recording.frame(number_of(recording, number));
            },
            py::arg("number"),
            "frame(number) -> Snapshot\n"
            "\n"
            "The Snapshot of a frame, from 0; -1 is the last. Raises IndexError.")
        .def_property_readonly("times", &times, "[frames] s, time of each frame.")
        .def_property_readonly(
            "scene_text", [](const Recording& one) { return one.header().scene_text; }, "The scene, as TOML.")
        .def_property_readonly(
            "sheets", [](const Recording& one) { return one.header().sheet_names; }, "Names of the sheets.")
        .def_property_readonly("end", &Recording::end,
                               "\"running\", \"complete\", \"interrupted\" or \"failed: ...\".")
        .def_property_readonly("wall_seconds", &Recording::wall_seconds, "Wall time of the run, s.")
        .def_property_readonly(
            "steps", [](const Recording& one) { return columns_by_name(one.steps()); },
            "The columns of all steps as arrays [steps] or [steps, 3], by the names of StepReport.")
        .def_property_readonly(
            "reactions", &recorded_reactions,
            "Reactions of each support and obstacle, by its name: \"force\" [steps, 3] N and\n"
            "\"moment\" [steps, 3] N m.")
        .def_property_readonly("gauges", &recorded_gauges,
                               "Readings of each gauge, by its name: arrays [steps, 3], by name.")
        .def_property_readonly(
            "events", [](const Recording& one) { return events_by_kind(one.events()); },
            "Events, as in Simulation.events.")
        .def("poses", &poses, py::arg("frame"),
             "poses(frame) -> dict\n"
             "\n"
             "Returns the matrix [4, 4] from the own frame of each obstacle and body to space, by name,\n"
             "in a frame.")
        .def(
            "measures",
            [](const Recording& one, double over,
               const std::variant<std::array<double, 3>, std::string>& about,
               const std::vector<double>& radii) {
                return py::module_::import("json").attr("loads")(
                    measures_json(measures_of(one, over, centre_of(about, radii))));
            },
            py::arg("over") = 0.0, py::arg("about") = "", py::arg("radii") = std::vector<double>{},
            "measures(over=0.0, about='', radii=[]) -> dict\n"
            "\n"
            "Returns measures for comparing runs, as `sherd info --measures --json`: sizes of fragments of\n"
            "more than `over` kg, the power law of their masses, length, shape and directions of cracks,\n"
            "peak forces. Radial and ring cracks are counted about a point [3] m at rest, or the first\n"
            "contact of the obstacle that `about` names, or '', the first crack; on circles with `radii`\n"
            "in m, or some that fit. Raises Error when there is no frame.")
        .def(
            "distance",
            [](const Recording& one, const Recording& other) {
                return py::module_::import("json").attr("loads")(
                    distance_json(fragment_distance(one, other)));
            },
            py::arg("other"),
            "distance(other) -> dict\n"
            "\n"
            "Compares the fragments of the last frames of two recordings, at rest, as\n"
            "`sherd info --distance --json`: \"rand\" and \"adjusted_rand\" are 1 when they are the\n"
            "same. Raises Error when there is no frame.")
        .def("ancestry", &parents, py::arg("earlier"), py::arg("later"),
             "ancestry(earlier, later) -> (faces, vertices, weights)\n"
             "\n"
             "Returns where the mesh of a later frame was in that of an earlier one: (faces [F], vertices "
             "[V,\n"
             "3], weights [V, 3]). Each later face was that face, or a part of it; each later vertex\n"
             "lay between three vertices, with these shares: (weights[..., None] *\n"
             "values[vertices]).sum(1) carries values over.");
}

}  // namespace sherd::python
