// SPDX-License-Identifier: GPL-3.0-or-later
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "app/help/key_reference.h"
#include "app/python/arrays.h"
#include "app/python/bindings.h"
#include "app/scene/read/scene.h"
#include "app/scene/read/shipped_scenes.h"

namespace sherd::python {
namespace {

using GivenArrays = std::map<std::string, std::pair<Numbers, Numbers>>;

GivenMeshes given_meshes(const GivenArrays& arrays) {
    GivenMeshes meshes;
    for (const auto& [name, mesh] : arrays) {
        const Positions positions = columns_of(mesh.first, name + ".positions");
        GivenMesh& given = meshes[name];
        for (Eigen::Index v = 0; v < positions.cols(); ++v) given.positions.emplace_back(positions.col(v));
        given.faces = rows_of<3>(mesh.second, name + ".faces");
    }
    return meshes;
}

std::vector<std::string> sheet_names(const Scene& scene) {
    std::vector<std::string> names;
    for (const SheetSpec& sheet : scene.sheets) names.push_back(sheet.name);
    return names;
}

}  // namespace

void bind_scene(py::module_& module) {
    constexpr std::size_t columns = 100;
    module.def(
        "scene_keys", [](const std::string& table) { return key_reference(table, columns); },
        py::arg("table") = "", "Returns the reference of the keys of scenes, of one table or of all.");
    py::class_<Scene>(module, "Scene", "A scene that has been read and checked.")
        .def(py::init([](const std::string& file, const std::vector<std::string>& overrides,
                         const std::string& variant) {
                 return read_scene(find_scene(file), {overrides, variant});
             }),
             py::arg("file"), py::arg("overrides"), py::arg("variant"))
        .def(py::init([](const std::string& text, const std::string& name,
                         const std::vector<std::string>& overrides, const std::string& variant,
                         const GivenArrays& meshes) {
                 return parse_scene(text, name, {overrides, variant}, given_meshes(meshes));
             }),
             py::arg("text"), py::arg("name"), py::arg("overrides"), py::arg("variant"), py::arg("meshes"))
        .def_property_readonly(
            "file", [](const Scene& scene) { return scene.file.string(); },
            "File from which the scene was read.")
        .def_readonly(
            "text", &Scene::text,
            "The scene as TOML, with variant and overrides as comments at the end; recordings store it.")
        .def_readonly("variant", &Scene::variant, "Name of the variant; \"\": none.")
        .def_readonly("duration", &Scene::duration, "s; in statics the last load factor, or length of path.")
        .def_property_readonly(
            "step", [](const Scene& scene) { return scene.simulation.stepper.step; },
            "s, length of a whole step.")
        .def_property_readonly("time_unit", &Scene::time_unit,
                               "Unit of all times: \"s\", or in statics \"load\" or \"path\".")
        .def_property_readonly("sheets", &sheet_names, "Names of the sheets, by `Snapshot.face_sheets`.");
}

}  // namespace sherd::python
