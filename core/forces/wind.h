// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/element_energy.h"
#include "core/shell/shell.h"
#include "core/state_visitor.h"

namespace sherd {

/// A wave of the air's velocity, amplitude cos(wave . x + frequency t + phase). Gusts are a sum of such
/// waves.
struct GustWave {
    Vector3d amplitude = Vector3d::Zero();  ///< m/s
    Vector3d wave = Vector3d::Zero();       ///< rad/m
    double frequency = 0;                   ///< rad/s
    double phase = 0;                       ///< rad
};

/// Moving or still air, and the triangles that it acts on.
struct Wind {
    Vector3d velocity = Vector3d::Zero();  ///< m/s
    std::vector<GustWave> gusts;           ///< added to the velocity
    double ramp = 0;         ///< s, velocity and gusts grow to full size in this time; 0: at once
    double density = 1.225;  ///< kg/m^3; dry air at sea level and 15 degrees C (ISO 2533)
    double drag = 1.2;       ///< coefficient of a face across the wind, as for square plates (Hoerner 1965)
    double lift = 1.5;       ///< slope of the normal coefficient with the angle to the wind, 1/rad
    double friction = 0.02;  ///< coefficient along the surface, for both sides together
    std::vector<Index> triangles;

    /// Velocity of the air at a place (m) and a time (s), m/s.
    Vector3d at(const Vector3d& place, double time) const;
    void visit_state(StateVisitor& visit) {
        auto& [velocity, gusts, ramp, density, drag, lift, friction, triangles] = *this;
        visit(triangles);
    }
};

/// Corners of triangles that the air drags along.
struct WindCorners {
    struct Corner {
        Index vertex;
        Vector3d with_air;   ///< m, where the corner would be if it moved with the air
        Matrix3d stiffness;  ///< N/m, K / (3 lag)
    };
    std::vector<Corner> corners;

    std::size_t size() const { return corners.size(); }
    std::array<Index, 1> vertices(std::size_t i) const { return {corners[i].vertex}; }
    double value(std::size_t i, const Vector3d& x) const {
        const Vector3d behind = x - corners[i].with_air;
        return 0.5 * behind.dot(corners[i].stiffness * behind);
    }
    Vector3d gradient(std::size_t i, const Vector3d& x) const {
        return corners[i].stiffness * (x - corners[i].with_air);
    }
    const Matrix3d& hessian(std::size_t i, const Vector3d&, Curvature) const { return corners[i].stiffness; }
};

/// The force of the air on a triangle of area A and unit normal n. With the velocity w of the air relative to
/// the triangle, w_n = n . w and w_t = w - w_n n, it is
///     F = rho A / 2 [ (drag |w_n| + lift |w_t|) w_n n + friction |w_t| w_t ].
/// For a plate across the wind this is its drag, drag rho A w^2 / 2. For a plate at a small angle a to the
/// wind it is a normal force lift sin a cos a rho A w^2 / 2, as of a thin wing whose flow separates at the
/// leading edge: the component across the wind is lift, and the component along the wind is drag. On a plate
/// parallel to the wind only friction remains.
///
/// An implicit step minimises a potential, and F has none. With the values of n, A, |w_n| and |w_t| at the
/// beginning of the step, F is linear in w, F = K w, with the symmetric positive semidefinite matrix
///     K = rho A / 2 [ (drag |w_n| + lift |w_t|) n n^T + friction |w_t| (1 - n n^T) ],
/// and each corner gets a third of F. At the end of the step w = u - v(x) = u - (x - origin) / lag
/// (StepContext), with the velocity u of the air, so that F is minus the gradient of
///     E(x) = lag/2 sum over corners of w^T K/3 w,
/// a convex quadratic: for all coefficients and step sizes the air only drives the sheet towards its own
/// velocity. The error due to the values at the beginning of the step is of the order of the step, and zero
/// in steady motion. Triangles do not shelter each other, and do not act on the air.
class WindEnergy : public ElementEnergy<WindCorners> {
  public:
    /// A triangle may be in one wind only. The shell must outlive this object.
    WindEnergy(const Shell& shell, std::vector<Wind> winds)
        : ElementEnergy({}), shell(shell), winds(std::move(winds)) {}
    void begin(const StepContext& step) override;
    void topology_changed(const ShellChange& change, const StepContext& step) override;
    Task task() const override { return Task::loads; }
    void visit_state(StateVisitor& visit) override {
        static_assert(has_only<WindEnergy, ElementEnergy<WindCorners>, decltype(shell), decltype(winds)>());
        ElementEnergy::visit_state(visit);
        visit(winds);
    }

  private:
    /// Velocity of the air, m/s, [3, V], at the corners of a wind's triangles. time: s.
    Positions air_at_corners(const Wind& wind, double time) const;

    const Shell& shell;
    std::vector<Wind> winds;
};

}  // namespace sherd
