// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/contact/geometry/distance.h"
#include "core/element_energy.h"

namespace sherd {

/// A vertex on one face of a crack (vertex 0), and a triangle at the opposite face (vertices 1, 2, 3). The
/// opposite face is the triangle's side from vertex 1 to vertex 2.
struct CrackFaceStencil {
    std::array<Index, 4> vertices;
    double stiffness;  ///< N/m
};

/// Signed distance, m, of the vertex from the opposite crack face, measured in the triangle's plane; negative
/// when the vertex and the triangle overlap.
double crack_face_opening(const PairPositions& x);
/// d(opening)/dx, [3, 4], without unit. Its columns sum to zero and exert no net torque.
PairPositions crack_face_opening_gradient(const PairPositions& x);
/// d2(opening)/dx2, 1/m.
PairHessian crack_face_opening_hessian(const PairPositions& x);

/// Energy, J, of a spring that resists overlap but neither opening nor sliding.
double value(const CrackFaceStencil& crack_face, const PairPositions& x);
/// dE/dx, N, [3, 4].
PairPositions gradient(const CrackFaceStencil& crack_face, const PairPositions& x);
/// d2E/dx2, N/m; with `convex`, only its Gauss-Newton part, which is positive semidefinite.
PairHessian hessian(const CrackFaceStencil& crack_face, const PairPositions& x, bool convex);

/// The crack faces of a shell, as elements.
struct CrackFaceElements {
    const std::vector<CrackFaceStencil>* crack_faces;  ///< must outlive this object

    std::size_t size() const { return crack_faces->size(); }
    const std::array<Index, 4>& vertices(std::size_t i) const { return (*crack_faces)[i].vertices; }
    double value(std::size_t i, const PairPositions& x) const { return sherd::value((*crack_faces)[i], x); }
    PairPositions gradient(std::size_t i, const PairPositions& x) const {
        return sherd::gradient((*crack_faces)[i], x);
    }
    PairHessian hessian(std::size_t i, const PairPositions& x, Curvature curvature) const {
        return sherd::hessian((*crack_faces)[i], x, curvature == Curvature::convex);
    }
};

/// Contact of crack faces that are still too close together for SheetContact.
class CrackFaceContact : public ElementEnergy<CrackFaceElements> {
  public:
    /// The stencils must outlive this object.
    explicit CrackFaceContact(const std::vector<CrackFaceStencil>& crack_faces)
        : ElementEnergy({&crack_faces}) {}
    Task task() const override { return Task::contact; }
    double largest_overlap(const Positions& x) const;  ///< m; 0 if no crack faces overlap
};

}  // namespace sherd
