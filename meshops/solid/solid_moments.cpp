// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshops/solid/solid_moments.h"

#include <Eigen/Geometry>

#include "meshops/mesh_measures.h"

namespace sherd {

SolidMoments solid_moments(const Mesh& mesh) {
    using Eigen::Matrix3d, Eigen::Vector3d;
    const MeshMeasures extent = measure(mesh);
    // The sums are over tetrahedra between each face and the middle of the mesh. With a distant point in
    // place of the middle, digits would be lost.
    const Vector3d middle = (extent.lower + extent.upper) / 2;
    SolidMoments sum{0, Vector3d::Zero(), Matrix3d::Zero()};
    for (const Face face : mesh.faces()) {
        const auto [p, q, r] = face_points(mesh, face);
        const Vector3d a = p - middle, b = q - middle, c = r - middle, all = a + b + c;
        const double volume = a.dot(b.cross(c)) / 6;
        sum.volume += volume;
        sum.centre += volume / 4 * all;
        sum.second +=
            volume / 20 * (all * all.transpose() + a * a.transpose() + b * b.transpose() + c * c.transpose());
    }
    sum.centre /= sum.volume;
    sum.second -= sum.volume * sum.centre * sum.centre.transpose();
    sum.centre += middle;
    return sum;
}

}  // namespace sherd
