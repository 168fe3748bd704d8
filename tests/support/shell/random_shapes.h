// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <random>

#include "core/elements/hinge.h"
#include "core/elements/membrane.h"

namespace sherd::test {

/// Uniform numbers from a seed, the same on every machine.
class Random {
  public:
    explicit Random(unsigned seed) : generator(seed) {}
    double uniform(double low, double high) {
        return low + (high - low) * (static_cast<double>(generator()) + 0.5) / 4294967296.0;
    }
    /// Whole number from 0 to count - 1.
    unsigned below(std::size_t count) {
        return static_cast<unsigned>(uniform(0, 1) * static_cast<double>(count));
    }
    template <class Matrix>
    Matrix matrix(double amplitude) {
        Matrix m;
        for (double& entry : m.reshaped()) entry = uniform(-amplitude, amplitude);
        return m;
    }
    Matrix3d rotation() {
        return Eigen::Quaterniond(matrix<Eigen::Vector4d>(1).normalized()).toRotationMatrix();
    }

  private:
    std::mt19937 generator;
};

/// Hinge of dihedral angle `angle` over an edge of length 1 along x. Apex i is at height h_i over the edge's
/// line, at a_i along it.
inline HingePositions folded_hinge(double angle, double a0, double h0, double a1, double h1) {
    HingePositions x;
    x.col(0).setZero();
    x.col(1) = Vector3d::UnitX();
    x.col(2) = Vector3d(a0, h0, 0);
    x.col(3) = Vector3d(a1, -h1 * std::cos(angle), h1 * std::sin(angle));
    return x;
}

/// Hinge anywhere in space with unequal triangles and the given angle.
inline HingePositions random_hinge(Random& random, double angle) {
    HingePositions x = folded_hinge(angle, random.uniform(-0.3, 1.3), random.uniform(0.2, 2),
                                    random.uniform(-0.3, 1.3), random.uniform(0.2, 2));
    x = (random.rotation() * x).eval();
    return x.colwise() + random.matrix<Vector3d>(3);
}

}  // namespace sherd::test
