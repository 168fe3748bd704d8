// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <vector>

#include "app/recording/recording.h"
#include "app/scene/scene.h"

namespace sherd {

/// Returns the first material axis of each face of a recording [F], at rest: unit vectors, computed from the
/// scene as in the run. Throws Error if the scene's meshes cannot be read any more, or differ from those
/// recorded.
std::vector<Vector3d> recorded_axes(const Scene& scene, const RecordingHeader& header,
                                    std::vector<std::string>& warnings);

/// Returns numbers at the corners of the faces of the unfractured mesh [3, F] that grow by one over `spacing`
/// (m) across the axes and are constant along them, as nearly as possible. Stripes lie at even numbers. Two
/// faces at an edge have the same numbers there but for an even number, and for the sign, which axes do not
/// have: so stripes close around a tube. Where stripes must begin or end, a face differs from a neighbour.
/// (Knoppel, Crane, Pinkall, Schroder, Stripe Patterns on Surfaces, 2015.)
Eigen::Matrix3Xd axis_stripes(const RecordingHeader& header, std::span<const Vector3d> axes, double spacing);

/// Interpolates the numbers to the corners of a frame's faces [3, F], which are parts of the faces of the
/// unfractured mesh.
Eigen::Matrix3Xd stripes_of_parts(const RestMesh& rest, const Eigen::Matrix3Xd& stripes);

}  // namespace sherd
