// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <vector>

#include "app/recording/recording.h"
#include "app/scene/scene.h"

namespace sherd {

/// The first material axis of each face of a recording [F], at rest: unit vectors, made from the scene as the
/// run made them. Throws Error when the scene's meshes are not to be had any more, or are others than those
/// recorded.
std::vector<Vector3d> recorded_axes(const Scene& scene, const RecordingHeader& header,
                                    std::vector<std::string>& warnings);

/// Numbers at the corners of the faces of the unbroken mesh [3, F] that grow by one over `spacing` (m) across
/// the axes and stay the same along them, as nearly as there are such. Stripes lie where they pass even
/// numbers; two faces at an edge have the same there but for an even number, and the sign, which axes do not
/// have: so stripes close around a tube. Where they must begin or end, a face differs from a neighbour.
/// (Knoppel, Crane, Pinkall, Schroder, Stripe Patterns on Surfaces, 2015.)
Eigen::Matrix3Xd axis_stripes(const RecordingHeader& header, std::span<const Vector3d> axes, double spacing);

/// Those at the corners of a frame's faces [3, F], which are parts of the faces of the unbroken mesh.
Eigen::Matrix3Xd stripes_of_parts(const RestMesh& rest, const Eigen::Matrix3Xd& stripes);

}  // namespace sherd
