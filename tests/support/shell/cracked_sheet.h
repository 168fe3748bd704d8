// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <complex>
#include <cstdio>

#include "core/bending/coupled_bending.h"
#include "core/membrane/membrane_energy.h"
#include "core/solver/newton.h"
#include "core/tips/crack_tip.h"
#include "core/vector.h"
#include "fracture/shell/breakable_shell.h"
#include "meshops/generate/generate.h"
#include "meshops/topology/edge_path.h"

namespace sherd::test {

// Solutions for a crack from -a to a on the x axis in an infinite sheet, isotropic with Young's modulus 1
// (source: Muskhelishvili, Some Basic Problems of the Mathematical Theory of Elasticity, 1953).

using Complex = std::complex<double>;

/// sqrt(z^2 - a^2), with a branch cut only between -a and a.
inline Complex crack_root(Complex z, double a) {
    return std::sqrt(z - a) * std::sqrt(z + a);
}

/// Displacement, m, at the point `at` in plane stress under the remote stress (xx, yy, xy).
inline Vector2d crack_displacement(const Vector2d& at, double a, double poisson, const Vector3d& stress) {
    const Complex z(at.x(), at.y()), traction(stress[1], -stress[2]);
    const Complex uniform((stress[1] - stress[0]) / 2, -stress[2]);
    const double kappa = (3 - poisson) / (1 + poisson);
    const auto opened = [&](Complex there) { return traction / 2.0 * crack_root(there, a); };
    const Complex phi = opened(z) - uniform / 2.0 * z,
                  omega = opened(std::conj(z)) + uniform / 2.0 * std::conj(z);
    const Complex slope = traction / 2.0 * z / crack_root(z, a) - uniform / 2.0;
    const Complex u = (1 + poisson) * (kappa * phi - omega - (z - std::conj(z)) * std::conj(slope));
    return {u.real(), u.imag()};
}

/// Deflection, m, at the point `at` of a Kirchhoff plate with the remote curvature (xx, yy, xy), 1/m.
inline double crack_deflection(const Vector2d& at, double a, double poisson, const Vector3d& curvature) {
    const Complex z(at.x(), at.y()), root = crack_root(z, a);
    const double kappa = (3 + poisson) / (1 - poisson), mean = (curvature[0] + curvature[1]) / 4;
    const double jump = curvature[0] - mean * (1 + kappa), even = curvature[0] + mean * (kappa - 1);
    const Complex twist(0, curvature[2]), area = 0.5 * (z * root - a * a * std::log(z + root));
    const Complex phi = (even * z - jump * root) / (2 * kappa);
    const Complex of_phi = (even * z * z / 2.0 - jump * area) / (2 * kappa);
    const Complex of_omega = ((even - 2.0 * twist) * z * z / 2.0 + jump * area) / 2.0;
    return ((std::conj(z) - z) * phi + of_phi + of_omega).real();
}

/// Deflection, m, of a plate with Young's modulus 1 near the tip of a crack on the negative x axis, with the
/// field of plate_field(). first, second: its factors k_1 and k_2.
inline double tip_deflection(const Vector2d& at, double poisson, double thickness, double first,
                             double second) {
    const double kappa = (3 + poisson) / (1 - poisson);
    const double scale = std::sqrt(2.0) * (1 + poisson) / thickness;
    const Complex z(at.x(), at.y()), c = scale * Complex(-first, second), root = std::sqrt(z);
    return (-(std::conj(z) - z) * c / kappa * root + 2.0 / 3 * (std::conj(c) - c / kappa) * z * root).real();
}

/// Square sheet about the origin, 6 m from the centre to the sides, with a crack on the x axis (from -1 to 1
/// in cracked_sheet()).
struct CrackedSheet {
    Shell shell;
    std::vector<CrackTip> tips;  ///< from left to right
    Material material;
};

inline constexpr double half_width = 6;
inline const Material cracked_material{.density = 1, .thickness = 0.01, .young = 1, .poisson = 0.3};

/// Flags [V] of vertices on the outline, or nearer to it than `margin`, m.
inline std::vector<char> near_outline(const Shell& shell, double margin) {
    std::vector<char> is_near(shell.rest.cols());
    for (Index v = 0; v < shell.rest.cols(); ++v)
        is_near[v] = shell.rest.col(v).head<2>().cwiseAbs().maxCoeff() > half_width - margin;
    return is_near;
}

/// Returns the tips at the given places. The sheet must have no others.
inline std::vector<CrackTip> tips_at(const Shell& shell, const std::vector<Vector3d>& places) {
    const VertexFaces around(shell);
    std::vector<char> foreign = near_outline(shell, 1e-9);
    std::vector<Index> vertices;
    for (const Vector3d& place : places) {
        Index nearest = 0;
        (shell.rest.colwise() - place).colwise().squaredNorm().minCoeff(&nearest);
        vertices.push_back(nearest);
        foreign[nearest] = 1;
    }
    std::vector<CrackTip> tips;
    for (const Index vertex : vertices) tips.push_back(crack_tip(shell, around, vertex, foreign));
    return tips;
}

inline Mesh square_mesh(double edge_length, unsigned seed, const std::vector<Polyline>& slits) {
    Polygon polygon;
    for (const auto& [x, y] : {std::pair(-1, -1), {1, -1}, {1, 1}, {-1, 1}})
        polygon.outline.emplace_back(half_width * x, half_width * y);
    polygon.slits = slits;
    return generate_polygon(polygon, {edge_length, Layout::delaunay, seed});
}

inline BreakableShell sheet_of(const Mesh& mesh, const Material& material = cracked_material) {
    SheetInput input;
    input.mesh = mesh;
    input.material = material;
    return BreakableShell({input});
}

/// Sheet with a slit along the x axis. slit: x of its two ends, m. Ends within the sheet are tips.
inline CrackedSheet slit_sheet(double edge_length, unsigned seed, std::array<double, 2> slit) {
    const Mesh mesh = square_mesh(edge_length, seed, {{{slit[0], 0}, {slit[1], 0}}});
    CrackedSheet sheet{sheet_of(mesh).mechanics(), {}, cracked_material};
    std::vector<Vector3d> tips;
    for (const double end : slit)
        if (std::abs(end) < half_width) tips.emplace_back(end, 0, 0);
    sheet.tips = tips_at(sheet.shell, tips);
    return sheet;
}

inline CrackedSheet cracked_sheet(double edge_length, unsigned seed) {
    return slit_sheet(edge_length, seed, {-1, 1});
}

/// Like cracked_sheet(), with the crack along edges of a mesh that was made without it.
inline CrackedSheet zigzag_sheet(double edge_length, unsigned seed) {
    BreakableShell breakable = sheet_of(square_mesh(edge_length, seed, {}));
    const std::vector<Edge> path = edge_path(breakable.mesh(), std::vector<Vector3d>{{-1, 0, 0}, {1, 0, 0}});
    breakable.fail(path);
    CrackedSheet sheet{breakable.mechanics(), {}, cracked_material};
    sheet.tips = tips_at(sheet.shell, {{-1, 0, 0}, {1, 0, 0}});
    return sheet;
}

/// Place of a vertex at rest. On the x axis, where the two crack faces coincide, its y is 0 if the vertex
/// belongs to faces above, and -0 if to faces below.
inline Vector2d sided_place(const Shell& shell, const VertexFaces& around, Index vertex) {
    Vector2d at = shell.rest.col(vertex).head<2>();
    double above = 0;
    for (const Index face : around[vertex])
        above += columns(shell.rest, shell.triangles[face].vertices).row(1).sum();
    if (std::abs(at.y()) < 1e-9) at.y() = std::copysign(0.0, above);
    return at;
}

/// Positions in equilibrium under some energies. Vertices that are `fixed` are moved by `displacement`, all
/// others are free to move along the directions of `guide`.
template <class Displacement>
Positions equilibrium(Shell shell, const std::vector<char>& fixed, const Matrix3d& guide,
                      const std::vector<Energy*>& energies, Displacement displacement) {
    shell.fixed = fixed;
    shell.guides = {guide};
    shell.guide.assign(fixed.size(), 1);
    Positions x = shell.rest;
    const VertexFaces around(shell);
    for (Index v = 0; v < x.cols(); ++v)
        if (fixed[v] != 0) {
            if constexpr (std::is_invocable_v<Displacement, Index>)
                x.col(v) += displacement(v);
            else
                x.col(v) += displacement(sided_place(shell, around, v));
        }
    TimeSpent spent;
    Potential potential(shell, energies, spent);
    EXPECT_TRUE(Newton(1e-12).minimise(potential, 20, x).converged);
    return x;
}

/// Positions of the sheet under a remote stress (xx, yy, xy), in units of Young's modulus. The outline is
/// moved as in an infinite sheet.
inline Positions stretched(const CrackedSheet& sheet, const Vector3d& stress) {
    MembraneEnergy membrane(sheet.shell.triangles);
    return equilibrium(sheet.shell, near_outline(sheet.shell, 1e-9), Vector3d(1, 1, 0).asDiagonal(),
                       {&membrane}, [&](const Vector2d& at) {
                           Vector3d displacement = Vector3d::Zero();
                           displacement.head<2>() = crack_displacement(at, 1, sheet.material.poisson, stress);
                           return displacement;
                       });
}

/// Positions of the sheet with a remote curvature (xx, yy, xy), 1/m, by linear theory. A strip along the
/// outline, `margin` m wide, is moved as in an infinite sheet.
inline Positions bent(const CrackedSheet& sheet, double margin, const Vector3d& curvature) {
    CoupledBending bending(sheet.shell, {});
    return equilibrium(sheet.shell, near_outline(sheet.shell, margin), Vector3d(0, 0, 1).asDiagonal(),
                       {&bending}, [&](const Vector2d& at) {
                           return Vector3d(0, 0, crack_deflection(at, 1, sheet.material.poisson, curvature));
                       });
}

/// Mean and standard deviation.
struct Spread {
    double mean, deviation;
};

inline Spread spread(const std::vector<double>& values) {
    const Eigen::Map<const VectorXd> all(values.data(), static_cast<Eigen::Index>(values.size()));
    return {all.mean(), std::sqrt((all.array() - all.mean()).square().mean())};
}

}  // namespace sherd::test
