// SPDX-License-Identifier: GPL-3.0-or-later
// Membrane models in bent thin sheets against theory: flat triangles lock, arcs do not. Prints the tables of
// docs/theory/membrane.md.
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numbers>

#include "tests/support/shell/random_shapes.h"
#include "tests/support/shell/theory.h"

namespace sherd {
namespace {

using enum MembraneModel;

const char* name_of(MembraneModel model) {
    return model == arc ? "arc" : "constant-strain";
}

StepperOptions coupled_options(MembraneModel membrane) {
    StepperOptions options;
    options.shell.bending = {BendingModel::coupled, exact_jacobian(BendingModel::coupled)};
    options.shell.membrane = membrane;
    options.gravity.setZero();
    return options;
}

/// Position of the point p of a flat sheet that is rolled downwards about an axis along y.
Vector3d rolled_up(const Vector3d& p, double radius) {
    return {radius * std::sin(p.x() / radius), p.y(), radius * (std::cos(p.x() / radius) - 1)};
}

/// Rectangle as irregular as meshes of other programs: a Delaunay mesh whose inner vertices are moved by up
/// to 0.3 edges along each axis.
Mesh uneven_rectangle(double width, double height, double edge) {
    Mesh mesh = generate_rectangle(width, height, {edge, Layout::delaunay, 1});
    test::Random random(1);
    const double way = 0.3 * edge;
    for (const Vertex v : mesh.vertices()) {
        const Point p = mesh.point(v);
        const double to_border = std::min({p.x(), p.y(), width - p.x(), height - p.y()});
        const double x = random.uniform(-way, way), y = random.uniform(-way, way);
        if (to_border > 1e-9) mesh.point(v) = Point(p.x() + x, p.y() + y, 0);
    }
    return mesh;
}

/// Error, %, of the end moments of a strip of length 12, width 4 and rigidity 1 that is rolled into a ring
/// with its ends held together. The moments follow by Clapeyron's theorem from the energy of bending and
/// stretching.
double ring_error(double thickness, double edge, MembraneModel membrane) {
    constexpr double length = 12, width = 4, turn = 2 * std::numbers::pi;
    SheetInput input;
    input.mesh = uneven_rectangle(length, width, edge);
    input.material = test::unit_plate(0, thickness);
    BreakableShell plate({input});
    Shell& sheet = plate.mechanics();
    for (Index v = 0; v < static_cast<Index>(sheet.mass.size()); ++v)
        sheet.position.col(v) = rolled_up(sheet.rest.col(v), length / turn);
    const auto is_end = [](const Vector3d& p) { return std::abs(p.x() - length / 2) > length / 2 - 1e-9; };
    StepperOptions options = coupled_options(membrane);
    options.shell.mirrors = test::clamp(sheet, test::select(sheet, is_end), 1);
    for (MirrorHinge& hinge :
         options.shell.mirrors)  // a full turn leaves the tangents of the ends, and moves their places
        hinge.offset = hinge.normal.dot(Vector3d(sheet.position.col(edge_and_apex(sheet, hinge.side)[0])));
    options.step = 1000;
    test::settle(sheet, options, 8);
    EXPECT_LT(sheet.velocity.cwiseAbs().maxCoeff(), 1e-7) << "has not settled";
    const ShellEnergies energies(sheet, options.shell);
    const double energy = energies.bending_value(sheet.position) + energies.membrane_value(sheet.position);
    return 100 * (energy / (0.5 * width * turn * turn / length) - 1);
}

// Triangles of constant strain take chords for fibres: sides in different directions shorten differently,
// which irregular meshes cannot accommodate.
TEST(TheoryMembrane, StripRolledIntoARing) {
    struct Case {
        double thickness, edge, flat_error;
    };
    for (const auto& [thickness, edge, flat_error] :
         {Case{0.03, 0.5, 1.4}, Case{0.01, 0.5, 3.4}, Case{0.003, 0.5, 6.4}, Case{0.01, 0.25, 1.2}}) {
        const double locks = edge * edge * 2 * std::numbers::pi / (12 * thickness);
        const double flat = ring_error(thickness, edge, constant_strain),
                     arcs = ring_error(thickness, edge, arc);
        std::printf("ring: t %.3f, h %.2f, h^2/(R t) %4.1f: constant-strain %5.2f, arc %5.2f %%\n", thickness,
                    edge, locks, flat, arcs);
        EXPECT_LT(std::abs(arcs), 0.3);
        EXPECT_NEAR(flat, flat_error, 0.3 * flat_error) << "correct docs/theory/membrane.md";
    }
}

/// Eighth of a cylinder with free ends that is pinched by two opposite forces at half its length: radius
/// 4.953 m, length 10.35 m, uneven meshes with `edges` edges around the quarter of its circumference.
class PinchedCylinder {
  public:
    PinchedCylinder(int edges, double thickness, MembraneModel membrane)
        : sheet(make_sheet(edges, thickness)), options(coupled_options(membrane)) {
        hold_on_planes();
        options.step = 1e3;
        options.tolerance = 1e-10;
        // Four of the eighths meet under each force: each carries a quarter of it.
        load.dead = point_forces(sheet.mechanics(), std::array{top()},
                                 Vector3d(0, 0, -force / 4 * std::pow(thickness / 0.01548, 3)));
        options.shell.loads = {load};
    }

    /// Deflection, m, of a ring as wide as the cylinder is long.
    static double theory() {
        const double rigidity = bending_rigidity({0.01, 0.01548, young, poisson});
        return (std::numbers::pi / 8 - 1 / std::numbers::pi) * force * std::pow(radius, 3) /
               (rigidity * 2 * half_length);
    }

    /// Deflection, m, of the mesh under a force that grows with the cube of the thickness.
    double deflection() {
        Shell& shell = sheet.mechanics();
        ImplicitStepper stepper(shell, options);
        for (int i = 0; i < 4; ++i) {
            stepper.begin();
            stepper.position = shell.position;
            const auto begin = std::chrono::steady_clock::now();
            const StepResult result = stepper.solve(500);
            seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
            iterations += result.iterations;
            EXPECT_TRUE(result);
            stepper.finish();
        }
        return shell.rest(2, top()) - shell.position(2, top());
    }

    int iterations = 0;
    double seconds = 0;

  private:
    static constexpr double radius = 4.953, half_length = 5.175;
    static constexpr double young = 10.5e6, poisson = 0.3125, force = 0.1;  // force at a thickness of 0.01548
    static constexpr double quarter = 0.5 * std::numbers::pi * radius;

    static BreakableShell make_sheet(int edges, double thickness) {
        SheetInput input;
        input.mesh = uneven_rectangle(quarter, half_length, quarter / edges);
        for (const Vertex v : input.mesh.vertices()) {
            const Point p = input.mesh.point(v);
            const Vector3d at = rolled_up({p.x(), p.y(), 0}, radius);
            input.mesh.point(v) = Point(at.x(), at.y(), at.z() + radius);
        }
        // so light that inertia in a step is negligible
        input.material = {0.01, thickness, young, poisson};
        return BreakableShell({input});
    }

    /// Vertex at the top of the cylinder, half way between its ends.
    Index top() const {
        Index best = 0;
        const Positions& rest = sheet.mechanics().rest;
        (rest.colwise() - Vector3d(0, 0, radius)).colwise().squaredNorm().minCoeff(&best);
        return best;
    }

    void hold_on_planes() {
        Shell& shell = sheet.mechanics();
        for (int planes = 1; planes < 8; ++planes) {
            Vector3d free(planes & 1 ? 0 : 1, planes & 2 ? 0 : 1, planes & 4 ? 0 : 1);
            shell.guides.push_back(free.asDiagonal());
        }
        for (int axis = 0; axis < 3; ++axis) {
            std::vector<char> on_plane(shell.rest.cols());
            for (Index v = 0; v < shell.rest.cols(); ++v) {
                on_plane[v] = std::abs(shell.rest(axis, v)) < 1e-9;
                if (on_plane[v]) shell.guide[v] = static_cast<char>(shell.guide[v] | 1 << axis);
            }
            for (const TriangleEdge& side : boundary_triangle_edges(shell, on_plane))
                options.shell.mirrors.push_back(symmetry_hinge(shell, side, Vector3d::Unit(axis), 1));
        }
    }

    BreakableShell sheet;
    StepperOptions options;
    Load load;
};

// A thin cylinder bends without stretching, like a ring as wide as the cylinder is long: by (pi / 8 - 1 /
// pi) P R^3 / (D L) under each of two forces P. The excess is the anticlastic bending near the free ends,
// within a distance of the square root of R t.
TEST(TheoryMembrane, ThinCylinderPinched) {
    for (const double thickness : {0.01548, 0.001548})
        for (const int edges : {8, 16, 32}) {
            for (const MembraneModel membrane : {constant_strain, arc}) {
                PinchedCylinder cylinder(edges, thickness, membrane);
                const double error = 100 * (cylinder.deflection() / PinchedCylinder::theory() - 1);
                std::printf("pinched cylinder, t %.5f, %2d edges, %-15s: %5.1f %%, %6.2f ms an iteration\n",
                            thickness, edges, name_of(membrane), error,
                            1000 * cylinder.seconds / cylinder.iterations);
                if (membrane == arc) {
                    EXPECT_NEAR(error, 1, edges == 8 ? 7 : edges == 16 ? 4 : 2.5);
                } else if (thickness < 0.01 && edges > 8) {
                    EXPECT_LT(error, -3) << "does not lock any more: correct docs/theory/membrane.md";
                }
            }
        }
}

/// Compression, over Euler's, at which a flat strip of length 1 m between guided ends buckles, with `edges`
/// edges along it.
double buckling_factor(int edges, MembraneModel membrane) {
    constexpr double thickness = 0.01, width = 0.25;
    BreakableShell plate = test::flat_plate(1, width, 1.0 / edges, test::unit_plate(0, thickness));
    Shell& sheet = plate.mechanics();
    for (Index v = 0; v < static_cast<Index>(sheet.mass.size()); ++v)
        sheet.fixed[v] = std::abs(sheet.rest(0, v) - 0.5) > 0.5 - 1e-9;
    ShellEnergies energies(sheet, coupled_options(membrane).shell);
    const double euler = std::pow(std::numbers::pi * thickness, 2) / 12;  // Euler's critical strain
    const auto is_stable = [&](double factor) {
        Positions x = sheet.rest;
        x.row(0) *= 1 - factor * euler;
        std::vector<std::pair<Index, Index>> pairs;
        for (const Energy* energy : energies.elastic()) energy->add_pattern(pairs);
        BlockMatrix matrix(static_cast<Index>(x.cols()), pairs, sheet.fixed);
        for (const Energy* energy : energies.elastic()) energy->add_hessian(x, Curvature::exact, matrix);
        const std::unique_ptr<LinearSolver> solver = cholesky_solver();
        solver->analyze(matrix);
        return solver->factorize(matrix);
    };
    double low = 0, high = 4;
    for (int i = 0; i < 30; ++i) {
        const double middle = 0.5 * (low + high);
        (is_stable(middle) ? low : high) = middle;
    }
    return low;
}

// Under compression arcs bow. The buckling load must converge to Euler's; on coarse meshes it is too small by
// the error of bending.
TEST(TheoryMembrane, CompressedStripBuckles) {
    for (const int edges : {4, 8, 16, 32}) {
        const double flat = buckling_factor(edges, constant_strain), arcs = buckling_factor(edges, arc);
        std::printf("buckling, %2d edges: constant-strain %.4f, arc %.4f of Euler's\n", edges, flat, arcs);
        // Arcs have all of the geometric stiffness; chords lack a share of it, a twelfth of the squared
        // angle of an edge.
        const double angle = std::numbers::pi / edges;
        EXPECT_NEAR(flat / arcs - 1, angle * angle / 12, 0.25 * angle * angle / 12);
        EXPECT_NEAR(arcs, 1, 2.5 * angle * angle / 12);
    }
}

/// Elastic energy, J, of a square of side 1 m and rigidity 1 N m whose rim is pushed together along x by
/// 0.02 m, after it has buckled from small random deflections.
double crushed_energy(int edges, MembraneModel membrane) {
    BreakableShell plate = test::flat_plate(1, 1, 1.0 / edges, test::unit_plate(0.3, 0.005));
    Shell& sheet = plate.mechanics();
    test::Random random(3);
    for (Index v = 0; v < static_cast<Index>(sheet.mass.size()); ++v) {
        const Vector3d rest = sheet.rest.col(v);
        sheet.position(0, v) *= 0.98;
        sheet.fixed[v] = std::min({rest.x(), rest.y(), 1 - rest.x(), 1 - rest.y()}) < 1e-9;
        if (!sheet.fixed[v])
            sheet.position(2, v) =
                0.03 * std::sin(std::numbers::pi * rest.x()) * std::sin(std::numbers::pi * rest.y()) +
                random.uniform(-1e-3, 1e-3);
    }
    StepperOptions options = coupled_options(membrane);
    options.step = 10;
    test::settle(sheet, options, 12);
    EXPECT_LT(sheet.velocity.cwiseAbs().maxCoeff(), 1e-4) << "has not settled";
    const ShellEnergies energies(sheet, options.shell);
    const double bending = energies.bending_value(sheet.position),
                 membrane_energy = energies.membrane_value(sheet.position);
    std::printf("crushed square, %2d edges, %-15s: bending %.1f, membrane %.1f J\n", edges, name_of(membrane),
                bending, membrane_energy);
    return bending + membrane_energy;
}

// Compressed arcs may bow; if that cost no energy, a crushed sheet would lose its energy on coarse meshes.
TEST(TheoryMembrane, CrushedSquareKeepsItsEnergy) {
    const double fine = crushed_energy(20, constant_strain);
    for (const int edges : {8, 12})
        for (const MembraneModel membrane : {constant_strain, arc}) {
            const double energy = crushed_energy(edges, membrane);
            std::printf("%44s %.2f of the finest\n", "", energy / fine);
            EXPECT_NEAR(energy, fine, 0.3 * fine) << "where wrinkles go depends on the mesh";
        }
}

}  // namespace
}  // namespace sherd
