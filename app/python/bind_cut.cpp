// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/python/arrays.h"
#include "app/python/bindings.h"
#include "fracture/mesh/crack_mesh.h"
#include "meshops/repair/triangle_mesh.h"
#include "meshops/topology/components.h"

namespace sherd::python {
namespace {

py::dict cut(const Numbers& positions, const Numbers& faces, const Numbers& edges) {
    const Positions columns = columns_of(positions, "positions");
    std::vector<Vector3d> points;
    for (Eigen::Index v = 0; v < columns.cols(); ++v) points.emplace_back(columns.col(v));
    CrackMesh cracks(triangle_mesh(points, rows_of<3>(faces, "faces")));
    cracks.fail(edges_of(cracks.mesh(), edges));

    const Mesh& mesh = cracks.mesh();
    std::vector<Vector3d> places;
    std::vector<Index> originals;
    for (const Vertex vertex : mesh.vertices()) {
        originals.push_back(static_cast<Index>(cracks.original(vertex)));
        places.push_back(points[static_cast<std::size_t>(originals.back())]);
    }
    std::vector<std::array<Index, 3>> corners;
    for (const Face face : mesh.faces()) {
        std::array<Index, 3>& three = corners.emplace_back();
        std::size_t corner = 0;
        for (const Vertex vertex : mesh.vertices_around_face(mesh.halfedge(face)))
            three[corner++] = static_cast<Index>(vertex);
    }
    py::dict result;
    result["positions"] = array_of(places);
    result["faces"] = array_of(corners);
    result["originals"] = array_of(originals);
    result["fragments"] = array_of(connected_components(mesh).of_face);
    return result;
}

}  // namespace

void bind_cut(py::module_& module) {
    module.def("cut", &cut, py::arg("positions"), py::arg("faces"), py::arg("edges"));
}

}  // namespace sherd::python
