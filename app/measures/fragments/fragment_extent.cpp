// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/measures/fragments/fragment_extent.h"

#include <Eigen/Eigenvalues>
#include <algorithm>

namespace sherd {
namespace {

struct Area {
    double size = 0;                     ///< m^2
    Vector3d first = Vector3d::Zero();   ///< m^3, first moment
    Matrix3d second = Matrix3d::Zero();  ///< m^4, second moments about the origin
    std::vector<std::size_t> faces = {};

    void add(std::size_t face, double area, const Matrix3d& corners) {
        const Vector3d sum = corners.rowwise().sum();
        size += area;
        first += area / 3 * sum;
        second += area / 12 * (corners * corners.transpose() + sum * sum.transpose());
        faces.push_back(face);
    }
};

FragmentExtent extent_of(const Area& of, const RestMesh& rest) {
    const Vector3d centre = of.first / of.size;
    const Eigen::SelfAdjointEigenSolver<Matrix3d> axes(of.second / of.size - centre * centre.transpose());
    Vector3d least = Vector3d::Zero(), most = Vector3d::Zero();
    for (const std::size_t face : of.faces)
        for (const Index corner : rest.faces[face]) {
            const Vector3d at = axes.eigenvectors().transpose() * (rest.position.col(corner) - centre);
            least = least.cwiseMin(at), most = most.cwiseMax(at);
        }
    const Vector3d extent = most - least;
    return {std::max(extent[2], extent[1]), std::min(extent[2], extent[1])};
}

}  // namespace

std::vector<FragmentExtent> fragment_extents(const Snapshot& frame) {
    std::vector<Area> areas;
    for (std::size_t f = 0; f < frame.faces.size(); ++f) {
        const auto fragment = static_cast<std::size_t>(frame.face_fragment[f]);
        if (areas.size() <= fragment) areas.resize(fragment + 1);
        Matrix3d corners;
        for (int i = 0; i < 3; ++i) corners.col(i) = frame.rest.position.col(frame.rest.faces[f][i]);
        areas[fragment].add(f, frame.rest.area[f], corners);
    }
    std::vector<FragmentExtent> extents;
    for (const Area& area : areas)
        extents.push_back(area.size > 0 ? extent_of(area, frame.rest) : FragmentExtent{});
    return extents;
}

}  // namespace sherd
