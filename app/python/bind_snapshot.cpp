// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/python/arrays.h"
#include "app/python/bindings.h"
#include "fracture/record/snapshot.h"
#include "meshops/shared_values.h"

namespace sherd::python {
namespace {

/// Returns the getter of a property: a view of the array that get(snapshot) returns, or None if it is empty.
template <class Get>
auto view_of(Get get) {
    return [get](py::object self) -> py::object {
        const auto& array = get(self.cast<const Snapshot&>());
        if (array.size() == 0) return py::none();
        return array_of(array, self);
    };
}

template <class Array>
auto view_of(Array Snapshot::*member) {
    return view_of([member](const Snapshot& one) -> const Array& { return one.*member; });
}

template <class Array>
auto view_of(Array RestMesh::*member) {
    return view_of([member](const Snapshot& one) -> const Array& { return one.rest.*member; });
}

template <class Array>
auto view_of(Array FaceFields::*member) {
    return view_of([member](const Snapshot& one) -> const Array& { return one.fields.*member; });
}

/// Returns the attributes that files gave the meshes: arrays, by their names in recordings. Shared values are
/// shown as numbers of rows.
py::dict look_of(const Snapshot& frame) {
    py::dict arrays;
    visit_surface_attributes([&](const auto& attribute) {
        const auto& list = frame.rest.look.*attribute.list;
        if (list.empty()) return;
        if constexpr (requires { shared_values(list); })
            arrays[attribute.recorded] = array_of(shared_values(list).number);
        else
            arrays[attribute.recorded] = array_of(list);
    });
    return arrays;
}

}  // namespace

void bind_snapshot(py::module_& module) {
    using S = Snapshot;
    py::class_<S>(module, "Snapshot",
                  "The sheets at one moment. Its arrays are read-only views that never\n"
                  "change.\n"
                  "\n"
                  "V, F, E: vertices, faces, edges; R: vertices of the mesh at rest, in which copies of a\n"
                  "vertex are one. Later snapshots of a run only append to these.")
        .def_readonly("step", &S::step, "Number of steps done.")
        .def_readonly("time", &S::time, "s")
        .def_property_readonly("positions", view_of(&S::position), "[V, 3] m")
        .def_property_readonly("velocities", view_of(&S::velocity), "[V, 3] m/s")
        .def_property_readonly("masses", view_of(&S::mass), "[V] kg")
        .def_property_readonly("originals", view_of(&S::original),
                               "[V] row of rest_positions that each vertex is, or is a copy of")
        .def_property_readonly("faces", view_of(&S::faces), "[F, 3] vertices of each face, counterclockwise")
        .def_property_readonly("face_fragments", view_of(&S::face_fragment),
                               "[F] number of the fragment, which it keeps while others split")
        .def_property_readonly("face_sheets", view_of(&S::face_sheet), "[F] number in Scene.sheets")
        .def_property_readonly("edges", view_of(&S::edges), "[E, 2] vertices of each edge")
        .def_property_readonly(
            "edge_states", view_of(&S::edge_state),
            "[E] 0: interior, has a hinge; 1: failed, still closed; 2: boundary of a crack or of the sheet")
        .def_property_readonly("edge_strains", view_of(&S::edge_strain),
                               "[E] 1/m, bending of the hinge, signed; 0 without one")
        .def_property_readonly(
            "edge_held", view_of(&S::edge_cohesive_share),
            "[E] cohesive share, 1 to 0, of an edge that opens gradually; None: no edge does")
        .def_property_readonly("rest_positions", view_of(&RestMesh::position), "[R, 3] m, at rest")
        .def_property_readonly("rest_faces", view_of(&RestMesh::faces), "[F, 3] rows of rest_positions")
        .def_property_readonly("rest_areas", view_of(&RestMesh::area), "[F] m^2, at rest")
        .def_property_readonly("thicknesses", view_of(&RestMesh::thickness), "[F] m")
        .def_property_readonly("rest_parents", view_of(&RestMesh::vertex_parents),
                               "[R, 3] vertices of the unbroken mesh between which each vertex lies")
        .def_property_readonly("rest_weights", view_of(&RestMesh::vertex_weights),
                               "[R, 3] shares of rest_parents, which sum to 1")
        .def_property_readonly("face_parents", view_of(&RestMesh::face_parent),
                               "[F] face of the unbroken mesh of which each face is a part")
        .def_property_readonly("curvature", view_of(&FaceFields::curvature),
                               "[F, 3] 1/m, change of curvature: 00, 11, 2 * 01; None: not requested")
        .def_property_readonly(
            "membrane_strain", view_of(&FaceFields::membrane_strain),
            "[F, 3] Green strain of the middle surface: 00, 11, 2 * 01; None: not requested")
        .def_property_readonly("stress_top", view_of(&FaceFields::stress_top),
                               "[F, 3] Pa, at the side of the normal: 00, 11, 01; None: not requested")
        .def_property_readonly("stress_bottom", view_of(&FaceFields::stress_bottom),
                               "[F, 3] Pa, at the other side; None: not requested")
        .def_property_readonly(
            "look", look_of,
            "Arrays by their names in recordings; attributes that files gave the meshes, such as\n"
            "\"vertex_colour\" [R, 4]. Materials and groups are rows, numbered from 0; -1: none.");
}

}  // namespace sherd::python
