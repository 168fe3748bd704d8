// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/render/render_stripes.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <Eigen/SparseCholesky>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <utility>

#include "app/scene/assemble/sheet/material_axes.h"
#include "app/scene/assemble/sheet/mesh.h"
#include "meshops/error.h"
#include "meshops/mesh_measures.h"
#include "meshops/random.h"

namespace sherd {
namespace {

/// Whether the faces of `mesh` are the faces of the recording from face `first` on, in the same positions or
/// all moved by the same vector. A run moves sheets that start too close to each other, which changes no
/// axis.
bool is_recorded(const Mesh& mesh, const RecordingHeader& header, std::size_t first) {
    if (first + mesh.number_of_faces() > header.rest_faces.size()) return false;
    std::optional<Vector3d> way;
    for (const Face face : mesh.faces()) {
        std::size_t corner = 0;
        for (const Vertex v : mesh.vertices_around_face(mesh.halfedge(face))) {
            const Vector3d made = position(mesh, v),
                           recorded =
                               header.rest_position.col(header.rest_faces[first + face.idx()][corner++]);
            if (!way) way = recorded - made;
            if (!Vector3d(made + *way).isApprox(recorded, 1e-9)) return false;
        }
    }
    return true;
}

/// Returns a sign for each corner of each face: +1 if the axis of the face points in the same direction as
/// the axis of the vertex, -1 if it points in the opposite direction. The axis of a vertex is that of the
/// first face around it: since axes have no sign, a direction must be chosen for each vertex.
std::vector<std::array<int, 3>> corner_signs(const RecordingHeader& header, std::span<const Vector3d> axes) {
    std::vector<int> first(header.rest_position.cols(), -1);
    std::vector<std::array<int, 3>> signs(axes.size());
    for (std::size_t f = 0; f < axes.size(); ++f)
        for (int k = 0; k < 3; ++k) {
            int& chosen = first[header.rest_faces[f][k]];
            if (chosen < 0) chosen = static_cast<int>(f);
            signs[f][k] = axes[f].dot(axes[chosen]) < 0 ? -1 : 1;
        }
    return signs;
}

/// An edge, directed from its vertex with the lower number to its vertex with the higher number. Signs are
/// relative to the axis of the lower vertex.
struct StripeEdge {
    double growth = 0;  ///< rad, growth of the phase along the edge: sum, then mean over its faces
    int faces = 0;      ///< number of its faces
    double weight = 0;  ///< sum of the cotangents of the opposite angles
    int turned = 1;     ///< -1: the axis of the higher vertex points in the opposite direction
};
using StripeEdges = std::map<std::pair<Index, Index>, StripeEdge>;

/// The unfractured mesh, with the data of which stripes are made.
struct StripeMesh {
    const RecordingHeader& header;
    std::vector<std::array<int, 3>> signs;
    StripeEdges edges;

    /// Two corners of a face, the corner with the lower vertex first, and the edge between them.
    struct Side {
        int low, high;
        StripeEdge& edge;
    };
    Side side(std::size_t f, int i, int j) {
        const auto& face = header.rest_faces[f];
        if (face[i] > face[j]) std::swap(i, j);
        return {i, j, edges[{face[i], face[j]}]};
    }
};

StripeMesh stripe_mesh(const RecordingHeader& header, std::span<const Vector3d> axes, double spacing) {
    constexpr double least_weight = 0.05;  // lower bound of a cotangent, so that a minimum exists
    StripeMesh mesh{header, corner_signs(header, axes), {}};
    for (std::size_t f = 0; f < axes.size(); ++f) {
        const auto& face = header.rest_faces[f];
        const auto place = [&](int k) -> Vector3d { return header.rest_position.col(face[k]); };
        const Vector3d normal = (place(1) - place(0)).cross(place(2) - place(0));
        if (!(normal.norm() > 0))
            throw Error("the directions of the material cannot be drawn: a face has no area", Fault::run);
        const Vector3d gradient = std::numbers::pi / spacing * normal.normalized().cross(axes[f]);
        for (int k = 0; k < 3; ++k) {
            const auto [low, high, edge] = mesh.side(f, k, (k + 1) % 3);
            const Vector3d a = place(low) - place((k + 2) % 3), b = place(high) - place((k + 2) % 3);
            edge.growth += mesh.signs[f][low] * gradient.dot(b - a);
            edge.weight += std::max(least_weight, a.dot(b) / normal.norm());
            edge.turned = mesh.signs[f][low] * mesh.signs[f][high];
            ++edge.faces;
        }
    }
    for (auto& [ends, edge] : mesh.edges) edge.growth /= edge.faces;
    return mesh;
}

/// Returns the matrix, [2 V0, 2 V0], of an energy of complex numbers z at the vertices: the sum over the
/// edges of weight times |z_high - exp(i growth) z_low|^2. Where `turned` is -1, the conjugate of z_high
/// takes the place of z_high.
Eigen::SparseMatrix<double> stripe_energy(const StripeMesh& mesh) {
    constexpr double shift = 1e-8;  // keeps the matrix invertible where the energy can be zero
    std::vector<Eigen::Triplet<double>> entries;
    for (const auto& [ends, edge] : mesh.edges) {
        const auto [low, high] = ends;
        Eigen::Matrix2d turn = Eigen::Rotation2Dd(edge.growth).toRotationMatrix();
        turn.row(1) *= edge.turned;
        for (int i = 0; i < 2; ++i) {
            for (const Index v : {low, high})
                entries.emplace_back(2 * v + i, 2 * v + i, edge.weight * (1 + shift));
            for (int j = 0; j < 2; ++j) {
                entries.emplace_back(2 * high + i, 2 * low + j, -edge.weight * turn(i, j));
                entries.emplace_back(2 * low + j, 2 * high + i, -edge.weight * turn(i, j));
            }
        }
    }
    // A vertex without faces has no phase; the matrix must be invertible nevertheless.
    for (Eigen::Index i = 0; i < 2 * mesh.header.rest_position.cols(); ++i) entries.emplace_back(i, i, 1e-12);
    const Eigen::Index size = 2 * mesh.header.rest_position.cols();
    Eigen::SparseMatrix<double> energy(size, size);
    energy.setFromTriplets(entries.begin(), entries.end());
    return energy;
}

/// Returns phases at the vertices, [V0] rad: the phases of the eigenvector that belongs to the energy's
/// smallest eigenvalue, by inverse iteration.
VectorXd smooth_phases(const StripeMesh& mesh) {
    constexpr int iterations = 40;  // more than enough unless two numbers of stripes fit equally well
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(stripe_energy(mesh));
    VectorXd area = VectorXd::Zero(2 * mesh.header.rest_position.cols());
    for (std::size_t f = 0; f < mesh.signs.size(); ++f)
        for (const Index v : mesh.header.rest_faces[f])
            area.segment<2>(2 * v).array() += mesh.header.rest_area[f] / 3;
    Random random(1);
    VectorXd field(area.size());
    for (double& part : field) part = 2 * random.uniform() - 1;
    for (int i = 0; i < iterations; ++i) {
        field = solver.solve(area.cwiseProduct(field)).eval();
        field /= field.cwiseAbs().maxCoeff();
    }
    if (solver.info() != Eigen::Success || !field.allFinite())
        throw Error("the directions of the material cannot be drawn: their equations have no solution",
                    Fault::run);
    VectorXd phases(field.size() / 2);
    for (Eigen::Index v = 0; v < phases.size(); ++v) phases[v] = std::atan2(field[2 * v + 1], field[2 * v]);
    return phases;
}

}  // namespace

std::vector<Vector3d> recorded_axes(const Scene& scene, const RecordingHeader& header,
                                    std::vector<std::string>& warnings) {
    std::vector<Vector3d> axes;
    std::vector<std::string> ignored;  // warnings of the mesh, which the run has shown
    for (const SheetSpec& sheet : scene.sheets) {
        const Mesh mesh = make_mesh(sheet, scene, ignored);
        if (!is_recorded(mesh, header, axes.size()))
            throw Error(fmt::format("{}: the mesh differs from the recorded one, so its axes are unknown",
                                    sheet.where));
        const std::vector<Vector3d> more = material_axes(sheet.axis, mesh, sheet.place, warnings);
        axes.insert(axes.end(), more.begin(), more.end());
    }
    if (axes.size() != header.rest_faces.size())
        throw Error(fmt::format("the recording has {} faces, the meshes of its scene have {}",
                                header.rest_faces.size(), axes.size()));
    return axes;
}

Eigen::Matrix3Xd axis_stripes(const RecordingHeader& header, std::span<const Vector3d> axes, double spacing) {
    using std::numbers::pi;
    StripeMesh mesh = stripe_mesh(header, axes, spacing);
    const VectorXd phases = smooth_phases(mesh);
    for (auto& [ends, edge] : mesh.edges) {
        const double change = edge.turned * phases[ends.second] - phases[ends.first];
        edge.growth += std::remainder(change - edge.growth, 2 * pi);
    }
    Eigen::Matrix3Xd stripes(3, axes.size());
    for (std::size_t f = 0; f < axes.size(); ++f) {
        stripes(0, f) = mesh.signs[f][0] * phases[header.rest_faces[f][0]] / pi;
        for (int k = 1; k < 3; ++k) {
            const auto [low, high, edge] = mesh.side(f, 0, k);
            const int sign = (low == 0 ? 1 : -1) * mesh.signs[f][low];
            stripes(k, f) = stripes(0, f) + sign * edge.growth / pi;
        }
    }
    return stripes;
}

Eigen::Matrix3Xd stripes_of_parts(const RestMesh& rest, const Eigen::Matrix3Xd& stripes) {
    Eigen::Matrix3Xd parts(3, rest.faces.size());
    for (std::size_t f = 0; f < rest.faces.size(); ++f)
        for (int k = 0; k < 3; ++k)
            parts(k, f) = place_in_parent(rest, f, k).dot(stripes.col(rest.face_parent[f]));
    return parts;
}

}  // namespace sherd
