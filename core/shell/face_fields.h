// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "core/vector.h"

namespace sherd {

struct Shell;

/// Choice of fields of faces.
struct FaceFieldChoice {
    bool stress = false, curvature = false, membrane_strain = false;

    bool any() const { return stress || curvature || membrane_strain; }
    bool operator==(const FaceFieldChoice&) const = default;
};

/// Strain of a face, and the stress that follows: tensors in the face's rest frame (frame_axes()).
///
/// The top of a face is the side to which its normal points; its vertices run counterclockwise as seen from
/// there. A positive curvature bends the sheet towards the normal, which squeezes the top. Through the
/// thickness t the strain is linear (Kirchhoff), so that the stress is
///     S = C (E - t/2 k) at the top and S = C (E + t/2 k) at the bottom
/// with the material's plane-stress elasticity C in the face's frame. S is the second Piola-Kirchhoff stress,
/// force over area at rest in directions that turn with the face; while strains are small it is the true
/// stress.
struct FaceState {
    Vector3d curvature;        ///< k, the change of curvature, 1/m: (00, 11, 2 * 01)
    Vector3d membrane_strain;  ///< E, Green strain of the middle surface: (00, 11, 2 * 01)
    Vector3d stress_top;       ///< Pa: (00, 11, 01)
    Vector3d stress_bottom;    ///< Pa
};

/// Returns the state of a face. strain: its Green strain; curvature: its change of curvature, 1/m.
FaceState face_state(const Shell& shell, Index face, const Vector3d& strain, const Vector3d& curvature);

/// Green strain of all faces, [3, F], from their corners at x [3, V] m.
Eigen::Matrix3Xd green_strains(const Shell& shell, const Positions& x);
/// Green strain of some faces, with a column for each of them.
Eigen::Matrix3Xd green_strains(const Shell& shell, const Positions& x, std::span<const Index> faces);

/// Strains and stresses (FaceState) of all faces, [3, F] each; fields that are not chosen are empty.
struct FaceFields {
    Eigen::Matrix3Xd curvature, membrane_strain, stress_top, stress_bottom;
};

/// Unit and description of a field for its readers.
struct FieldMeaning {
    const char* unit;
    const char* description;
    bool twice;  ///< whether the third component is 2 * 01
};

/// Calls visit(name, array, meaning) for each field.
template <class F, class Visit>
void visit_fields(F& fields, Visit visit) {
    using Meaning = FieldMeaning;
    visit("curvature", fields.curvature,
          Meaning{"1/m",
                  "change of curvature in the axes face/axes, 00, 11 and 2 * 01; positive where the sheet "
                  "bends towards the face's normal",
                  true});
    visit("membrane_strain", fields.membrane_strain,
          Meaning{"1", "Green strain of the middle surface in the axes face/axes, 00, 11 and 2 * 01", true});
    visit("stress_top", fields.stress_top,
          Meaning{"Pa",
                  "second Piola-Kirchhoff stress in the axes face/axes, 00, 11 and 01, at the surface to "
                  "which the face's normal points",
                  false});
    visit("stress_bottom", fields.stress_bottom,
          Meaning{"Pa", "second Piola-Kirchhoff stress in the same axes at the opposite surface", false});
}

/// Returns the chosen fields. strains, curvatures: [3, F], ShellEnergies::face_strains() and
/// face_curvatures().
FaceFields face_fields(const Shell& shell, const Eigen::Matrix3Xd& strains,
                       const Eigen::Matrix3Xd& curvatures, const FaceFieldChoice& choice);

/// The fields that are not empty.
FaceFieldChoice choice_of(const FaceFields& fields);

/// Principal values of each face's tensor, [2, F], the larger values first. twice: see FieldMeaning.
Eigen::Matrix2Xd principal_values(const Eigen::Matrix3Xd& tensors, bool twice);

/// The largest (most tensile) principal stress of each face at its two surfaces, Pa, [F].
VectorXd largest_stress(const FaceFields& fields);

/// The principal curvature of largest magnitude of each face, 1/m, signed, [F].
VectorXd largest_curvature(const FaceFields& fields);

/// Largest value of a field, and its face.
struct FieldPeak {
    double value = 0;
    Index face = 0;
    bool top = false;  ///< whether the value is at the top; only for stress
};

/// The largest of largest_stress(). There must be a face with stress.
FieldPeak stress_peak(const FaceFields& fields);
/// The largest of largest_curvature() in magnitude. There must be a face with curvature.
FieldPeak curvature_peak(const FaceFields& fields);

}  // namespace sherd
