// SPDX-License-Identifier: GPL-3.0-or-later
#include <pybind11/stl.h>

#include "app/python/arrays.h"
#include "app/python/bindings.h"
#include "app/python/scene_mechanics.h"

namespace sherd::python {
namespace {

/// Lower triangle in the form of scipy.sparse.csc_matrix: values, rows, starts of columns.
py::tuple hessian(SceneMechanics& mechanics, const Numbers& positions) {
    const BlockMatrix matrix = mechanics.hessian(mechanics.placed(columns_of(positions, "positions")));
    const auto list = [](auto span) { return numbers(span.data(), span.size(), 1); };
    return py::make_tuple(list(matrix.values()), list(matrix.rows()), list(matrix.columns()));
}

py::dict fields(SceneMechanics& mechanics, const Numbers& positions) {
    const FaceFields found = mechanics.fields(mechanics.placed(columns_of(positions, "positions")));
    py::dict by_name;
    visit_fields(found, [&](const char* name, const Eigen::Matrix3Xd& values, const FieldMeaning&) {
        by_name[name] = array_of(values);
    });
    return by_name;
}

}  // namespace

void bind_mechanics(py::module_& module) {
    using M = SceneMechanics;
    py::class_<M>(module, "Mechanics", "The elasticity of a scene's sheets, without time.")
        .def(py::init<const Scene&>(), py::arg("scene"))
        .def_property_readonly("warnings", &M::warnings, "Warnings about the scene, as sentences.")
        .def_property_readonly(
            "rest_positions", [](const M& one) { return array_of(one.shell().rest); }, "[V, 3] m, a copy.")
        .def_property_readonly(
            "positions", [](const M& one) { return array_of(one.shell().position); },
            "[V, 3] m, where the scene starts, a copy.")
        .def_property_readonly(
            "masses", [](const M& one) { return array_of(one.shell().mass); }, "[V] kg, lumped, a copy.")
        .def_property_readonly(
            "faces", [](const M& one) { return array_of(corners_of(one.shell())); },
            "[F, 3] vertices, a copy.")
        .def(
            "energies",
            [](M& one, const Numbers& positions) {
                const auto [bending, membrane] = one.energies(one.placed(columns_of(positions, "positions")));
                py::dict parts;
                parts["bending"] = bending;
                parts["membrane"] = membrane;
                return parts;
            },
            py::arg("positions"),
            "energies(positions) -> dict\n"
            "\n"
            "Returns the energies, J, of \"bending\" and \"membrane\", at positions [V, 3] m.")
        .def(
            "gradient",
            [](M& one, const Numbers& positions) {
                return array_of(one.gradient(one.placed(columns_of(positions, "positions"))));
            },
            py::arg("positions"),
            "gradient(positions) -> array\n"
            "\n"
            "Returns the derivative of the energy by the positions, [V, 3] N, at positions [V, 3] m: minus\n"
            "the force. Pins and clamps have no effect here.")
        .def("_hessian", &hessian, py::arg("positions"))
        .def("fields", &fields, py::arg("positions"),
             "fields(positions) -> dict\n"
             "\n"
             "Returns fields of each face at positions [V, 3] m, as in Snapshot: \"curvature\",\n"
             "\"membrane_strain\", \"stress_top\", \"stress_bottom\", [F, 3] each.");
}

}  // namespace sherd::python
