// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <vector>

#include "app/recording/recording.h"
#include "app/scene/scene.h"

namespace sherd {

/// Returns the first material axis of each face of the unfractured mesh, [F0]: unit vectors, computed from
/// the scene as in the run. Throws Error if the scene's meshes cannot be read any more, or differ from the
/// recorded ones.
std::vector<Vector3d> recorded_axes(const Scene& scene, const RecordingHeader& header,
                                    std::vector<std::string>& warnings);

/// Returns stripe numbers at the corners of the faces of the unfractured mesh, [3, F0]. As nearly as
/// possible, the numbers grow by one over the distance `spacing` (m) across the axes, and are constant along
/// the axes. Stripes lie at even numbers. At a common edge the numbers of two faces are equal except for an
/// even number, and for the sign, which axes do not have; so stripes close around a tube. Where stripes must
/// begin or end, the numbers of two faces differ. (Knoppel, Crane, Pinkall, Schroder, Stripe Patterns on
/// Surfaces, 2015.)
Eigen::Matrix3Xd axis_stripes(const RecordingHeader& header, std::span<const Vector3d> axes, double spacing);

/// Returns stripe numbers at the corners of a frame's faces, [3, F], which are parts of the faces of the
/// unfractured mesh: interpolates `stripes`, from axis_stripes().
Eigen::Matrix3Xd stripes_of_parts(const RestMesh& rest, const Eigen::Matrix3Xd& stripes);

}  // namespace sherd
