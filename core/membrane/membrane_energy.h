// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/element_energy.h"
#include "core/shell/shell.h"

namespace sherd {

/// The membranes of a shell's triangles.
struct MembraneElements {
    const std::vector<TriangleStencil>* triangles;  ///< must outlive this object

    std::size_t size() const { return triangles->size(); }
    const std::array<Index, 3>& vertices(std::size_t i) const { return (*triangles)[i].vertices; }
    double value(std::size_t i, const TrianglePositions& x) const {
        return sherd::value((*triangles)[i].membrane, x);
    }
    TrianglePositions gradient(std::size_t i, const TrianglePositions& x) const {
        return sherd::gradient((*triangles)[i].membrane, x);
    }
    Eigen::Matrix<double, 9, 9> hessian(std::size_t i, const TrianglePositions& x,
                                        Curvature curvature) const {
        return sherd::hessian((*triangles)[i].membrane, x, curvature == Curvature::convex);
    }
};

/// Membrane energy of all triangles of a shell. The list of triangles must outlive this object.
class MembraneEnergy : public ElementEnergy<MembraneElements> {
  public:
    explicit MembraneEnergy(const std::vector<TriangleStencil>& triangles) : ElementEnergy({&triangles}) {}
};

}  // namespace sherd
