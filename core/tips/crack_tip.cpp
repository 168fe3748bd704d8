// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tips/crack_tip.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <Eigen/SVD>
#include <algorithm>
#include <set>
#include <stdexcept>
#include <string>

namespace sherd {
namespace {

/// Area times the unit normal, m^2.
Vector3d area_normal(const TrianglePositions& x) {
    return 0.5 * Vector3d(x.col(1) - x.col(0)).cross(Vector3d(x.col(2) - x.col(0)));
}

/// The other ends of the boundary sides at a vertex.
std::vector<Index> boundary_neighbours(const Shell& shell, const VertexFaces& around, Index vertex) {
    std::vector<Index> once;
    for (const Index face : around[vertex])
        for (const Index other : shell.triangles[face].vertices) {
            if (other == vertex) continue;
            const auto known = std::ranges::find(once, other);
            if (known == once.end())
                once.push_back(other);
            else
                once.erase(known);
        }
    return once;
}

/// The rings 0 to `most` of a tip, as far as they are nearer to the tip than any foreign vertex. The tip
/// itself does not count as foreign.
std::vector<std::vector<Index>> rings_around(const Shell& shell, const VertexFaces& around, Index vertex,
                                             std::span<const char> foreign, int most) {
    std::vector<std::vector<Index>> rings{{vertex}};
    std::set<Index> seen{vertex};
    while (static_cast<int>(rings.size()) <= most) {
        std::vector<Index> next;
        for (const Index near : rings.back())
            for (const Index face : around[near])
                for (const Index other : shell.triangles[face].vertices)
                    if (seen.insert(other).second) next.push_back(other);
        if (next.empty() || std::ranges::any_of(next, [&](Index v) { return foreign[v] != 0; })) break;
        std::ranges::sort(next);
        rings.push_back(std::move(next));
    }
    return rings;
}

/// The vertices along the boundary from `first` on, away from `tip`, at most `most`.
std::vector<Index> crack_face_from(const Shell& shell, const VertexFaces& around, Index tip, Index first,
                                   std::size_t most) {
    std::vector<Index> crack_face{first};
    for (Index before = tip; crack_face.size() < most;) {
        std::vector<Index> next = boundary_neighbours(shell, around, crack_face.back());
        std::erase(next, before);
        if (next.size() != 1 || next.front() == tip) break;
        before = crack_face.back();
        crack_face.push_back(next.front());
    }
    return crack_face;
}

}  // namespace

VertexFaces::VertexFaces(const Shell& shell)
    : first(shell.rest.cols() + 1, 0), faces(3 * shell.triangles.size()) {
    for (const TriangleStencil& triangle : shell.triangles)
        for (const Index v : triangle.vertices) ++first[v + 1];
    for (std::size_t v = 1; v < first.size(); ++v) first[v] += first[v - 1];
    std::vector<Index> next(first.begin(), first.end() - 1);
    for (std::size_t face = 0; face < shell.triangles.size(); ++face)
        for (const Index v : shell.triangles[face].vertices) faces[next[v]++] = static_cast<Index>(face);
}

Eigen::Matrix<double, 3, 2> CrackTip::axes() const {
    Eigen::Matrix<double, 3, 2> both;
    both << direction, normal.cross(direction);
    return both;
}

CrackTip crack_tip(const Shell& shell, const VertexFaces& around, Index vertex, std::span<const char> foreign,
                   int most) {
    const std::vector<Index> crack_faces = boundary_neighbours(shell, around, vertex);
    if (crack_faces.size() != 2)
        throw std::invalid_argument("vertex " + std::to_string(vertex) + " has " +
                                    std::to_string(crack_faces.size()) +
                                    " boundary edges: it is not a crack tip");
    CrackTip tip;
    tip.vertex = vertex;
    tip.normal = rest_normal(shell, around, vertex);
    Vector3d away = Vector3d::Zero();
    for (const Index crack_face : crack_faces)
        away += (shell.rest.col(vertex) - shell.rest.col(crack_face)).normalized();
    tip.direction = (away - tip.normal.dot(away) * tip.normal).normalized();
    tip.rings = rings_around(shell, around, vertex, foreign, most);
    for (int side = 0; side < 2; ++side)
        tip.crack_faces[side] =
            crack_face_from(shell, around, vertex, crack_faces[side], tip.rings.size() + 1);
    return tip;
}

Vector3d rest_normal(const Shell& shell, const VertexFaces& around, Index vertex) {
    Vector3d sum = Vector3d::Zero();
    for (const Index face : around[vertex])
        sum += area_normal(columns(shell.rest, shell.triangles[face].vertices));
    return sum.normalized();
}

Matrix3d smallest_turn(const Vector3d& from, const Vector3d& to) {
    const Matrix3d cross = cross_matrix(from.cross(to));
    return Matrix3d::Identity() + cross + cross * cross / (1 + from.dot(to));
}

Matrix3d rotation_at(const Shell& shell, const VertexFaces& around, Index vertex, const Positions& x) {
    Matrix3d sum = Matrix3d::Zero();
    for (const Index face : around[vertex]) {
        const auto& [vertices, membrane] = shell.triangles[face];
        const TrianglePositions rest = columns(shell.rest, vertices), now = columns(x, vertices);
        sum += membrane.area * (deformation_gradient(membrane, now) * frame_axes(rest).transpose() +
                                area_normal(now).normalized() * area_normal(rest).normalized().transpose());
    }
    const Eigen::JacobiSVD<Matrix3d> svd(sum, Eigen::ComputeFullU | Eigen::ComputeFullV);
    Matrix3d proper = Matrix3d::Identity();
    proper(2, 2) = (svd.matrixU() * svd.matrixV().transpose()).determinant();
    return svd.matrixU() * proper * svd.matrixV().transpose();
}

void make_unique(std::vector<Index>& numbers) {
    std::ranges::sort(numbers);
    numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
}

std::vector<Index> faces_around(const VertexFaces& around, const CrackTip& tip, int last) {
    std::vector<Index> faces;
    for (int ring = 0; ring <= last && ring < static_cast<int>(tip.rings.size()); ++ring)
        for (const Index vertex : tip.rings[ring])
            faces.insert(faces.end(), around[vertex].begin(), around[vertex].end());
    make_unique(faces);
    return faces;
}

}  // namespace sherd
