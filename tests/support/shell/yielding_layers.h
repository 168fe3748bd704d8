// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/LU>
#include <cmath>
#include <vector>

#include "core/vector.h"

/// Bent sheet of steel, 1 mm thick, computed in layers: the reference for yielding sections. Units are SI.
namespace sherd::test::yielding {

inline constexpr double young = 2.1e11, poisson = 0.3, yield = 235e6, thickness = 0.001;
inline constexpr double yield_moment = yield * thickness * thickness / 6;
inline constexpr double first =
    2 * yield / (young * thickness);  // 1/m; curvature at first yield under bending in one direction

inline Matrix3d plane_stress() {
    const double plate = young / (1 - poisson * poisson);
    return Matrix3d{
        {plate, poisson * plate, 0}, {poisson * plate, plate, 0}, {0, 0, plate * (1 - poisson) / 2}};
}

inline Matrix3d rigidity() {
    return std::pow(thickness, 3) / 12 * plane_stress();
}

inline double mises(const Vector3d& s) {
    return std::sqrt(s[0] * s[0] + s[1] * s[1] - s[0] * s[1] + 3 * s[2] * s[2]);
}

/// Section in layers of perfectly plastic material, each with its own plastic strain.
class Layers {
  public:
    Vector3d bend(const Vector3d& curvature) {
        Vector3d moment = Vector3d::Zero();
        for (int i = 0; i < count; ++i) {
            const double height = thickness / 2 * (i + 0.5) / count;
            const Vector3d strain = height * curvature - plastic[i], stress = returned(strain);
            plastic[i] = height * curvature - plane_stress().inverse() * stress;
            moment += 2 * height * thickness / 2 / count * stress;
        }
        return moment;
    }

    /// Curvature that remains when a section of this `curvature`, which bears `moment`, is released.
    static Vector3d plastic_curvature(const Vector3d& curvature, const Vector3d& moment) {
        return curvature - rigidity().inverse() * moment;
    }

  private:
    /// Stress within the yield surface that is nearest in energy to the elastic stress of `strain`, by
    /// bisection.
    static Vector3d returned(const Vector3d& strain) {
        if (Vector3d trial = plane_stress() * strain; mises(trial) <= yield) return trial;
        const Matrix3d form{{1, -0.5, 0}, {-0.5, 1, 0}, {0, 0, 3}}, compliance = plane_stress().inverse();
        const auto with = [&](double share) {
            return Vector3d((compliance + share * form).inverse() * strain);
        };
        double least = 0, most = 1 / young;
        while (mises(with(most)) > yield) most *= 2;
        for (int i = 0; i < 60; ++i) {
            const double middle = (least + most) / 2;
            (mises(with(middle)) > yield ? least : most) = middle;
        }
        return with(most);
    }

    static constexpr int count = 200;
    std::vector<Vector3d> plastic = std::vector<Vector3d>(count, Vector3d::Zero());
};

}  // namespace sherd::test::yielding
