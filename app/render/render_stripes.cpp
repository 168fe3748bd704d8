// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/render/render_stripes.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <Eigen/SparseCholesky>
#include <array>

#include "app/scene/material_axis.h"
#include "app/scene/scene_mesh.h"
#include "meshops/error.h"

namespace sherd {
namespace {

/// Whether the faces of `mesh` are those of the recording from face `first` on.
bool is_recorded(const Mesh& mesh, const RecordingHeader& header, std::size_t first) {
    if (first + mesh.number_of_faces() > header.rest_faces.size()) return false;
    for (const Face face : mesh.faces()) {
        std::size_t corner = 0;
        for (const Vertex v : mesh.vertices_around_face(mesh.halfedge(face))) {
            const Point& p = mesh.point(v);
            const Vector3d recorded =
                header.rest_position.col(header.rest_faces[first + face.idx()][corner++]);
            if (!Vector3d(p.x(), p.y(), p.z()).isApprox(recorded, 1e-9)) return false;
        }
    }
    return true;
}

/// The gradients of the three hat functions of a triangle, 1/m, and its area, m^2.
struct HatFunctions {
    std::array<Vector3d, 3> gradient;
    Vector3d normal;
    double area;
};

HatFunctions hat_functions(const RecordingHeader& header, const std::array<Index, 3>& face) {
    const Vector3d p[3] = {header.rest_position.col(face[0]), header.rest_position.col(face[1]),
                           header.rest_position.col(face[2])};
    const Vector3d doubled = (p[1] - p[0]).cross(p[2] - p[0]);
    HatFunctions hats;
    hats.area = doubled.norm() / 2;
    hats.normal = doubled.normalized();
    for (int k = 0; k < 3; ++k)
        hats.gradient[k] = hats.normal.cross(p[(k + 2) % 3] - p[(k + 1) % 3]) / (2 * hats.area);
    return hats;
}

}  // namespace

std::vector<Vector3d> recorded_axes(const Scene& scene, const RecordingHeader& header,
                                    std::vector<std::string>& warnings) {
    std::vector<Vector3d> axes;
    std::vector<std::string> ignored;  // of the mesh: the run has told them
    for (const SheetSpec& sheet : scene.sheets) {
        const Mesh mesh = make_mesh(sheet, scene, ignored);
        if (!is_recorded(mesh, header, axes.size()))
            throw Error(fmt::format(
                "{}: the mesh is not the one that was recorded, so its axes are not known", sheet.where));
        const std::vector<Vector3d> more = material_axes(sheet.axis, mesh, sheet.place, warnings);
        axes.insert(axes.end(), more.begin(), more.end());
    }
    if (axes.size() != header.rest_faces.size())
        throw Error(fmt::format("the recording has {} faces, the meshes of its scene have {}",
                                header.rest_faces.size(), axes.size()));
    return axes;
}

VectorXd axis_stripes(const RecordingHeader& header, std::span<const Vector3d> axes, double spacing) {
    const Eigen::Index count = header.rest_position.cols();
    std::vector<Eigen::Triplet<double>> entries;
    VectorXd right = VectorXd::Zero(count);
    for (std::size_t f = 0; f < header.rest_faces.size(); ++f) {
        const auto& face = header.rest_faces[f];
        const HatFunctions hats = hat_functions(header, face);
        const Vector3d wanted = hats.normal.cross(axes[f]) / spacing;
        for (int i = 0; i < 3; ++i) {
            right[face[i]] += hats.area * hats.gradient[i].dot(wanted);
            for (int j = 0; j < 3; ++j)
                entries.emplace_back(face[i], face[j], hats.area * hats.gradient[i].dot(hats.gradient[j]));
        }
    }
    // A constant is left free on every connected part: a little weight holds it.
    for (Eigen::Index v = 0; v < count; ++v) entries.emplace_back(v, v, 1e-9);
    Eigen::SparseMatrix<double> matrix(count, count);
    matrix.setFromTriplets(entries.begin(), entries.end());
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(matrix);
    if (solver.info() != Eigen::Success)
        throw Error("the directions of the material cannot be drawn: a face has no area", Fault::run);
    return solver.solve(right);
}

}  // namespace sherd
