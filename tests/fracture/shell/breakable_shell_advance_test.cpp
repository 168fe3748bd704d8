// SPDX-License-Identifier: GPL-3.0-or-later
// A sheet whose triangles change with a crack must remain the same sheet. If it did not, it would gain or
// lose mass or momentum, or bend, stretch or fracture unlike a sheet of these triangles.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <map>

#include "core/bending/coupled_bending.h"
#include "core/membrane/membrane_energy.h"
#include "meshops/generate/generate.h"
#include "tests/support/shell/advanced_sheet.h"

namespace sherd {
namespace {

/// All data of a shell that its mesh and masses determine must be those of a shell built from this mesh.
void expect_made_of_its_mesh(const BreakableShell& sheet) {
    const Shell& shell = sheet.mechanics();
    const Mesh& mesh = sheet.mesh();
    RC_ASSERT(mesh.is_valid(false));
    RC_ASSERT(shell.triangles.size() == mesh.number_of_faces());
    RC_ASSERT(shell.edge_hinge.size() == mesh.number_of_edges());
    RC_ASSERT(static_cast<std::size_t>(shell.rest.cols()) == mesh.number_of_vertices());
    VectorXd mass = VectorXd::Zero(shell.mass.size());
    for (const Face face : mesh.faces()) {
        const auto& vertices = shell.triangles[face].vertices;
        RC_ASSERT(vertices == face_vertices(mesh, face));
        for (const Index v : vertices) mass[v] += shell.face_mass[face] / 3;
    }
    RC_ASSERT((mass - shell.mass).cwiseAbs().maxCoeff() <= 1e-13 * mass.maxCoeff());
    for (const Vertex v : mesh.vertices())
        RC_ASSERT(Vector3d(shell.rest.col(static_cast<Index>(v))) == position(mesh, v));
    std::size_t hinges = 0;
    for (const Edge edge : mesh.edges()) {
        const Index hinge = sheet.hinge_of_edge(edge);
        RC_ASSERT((hinge >= 0) == (sheet.cracks().state(edge) == EdgeState::interior));
        RC_ASSERT(mesh.is_border(edge) == (sheet.cracks().state(edge) == EdgeState::boundary));
        if (hinge < 0) continue;
        ++hinges;
        RC_ASSERT(sheet.edge_of_hinge(hinge).idx() == edge.idx());
    }
    RC_ASSERT(hinges == shell.hinges.size());
}

void expect_same_shell(const BreakableShell& sheet, const BreakableShell& anew) {
    const Shell &one = sheet.mechanics(), &other = anew.mechanics();
    RC_ASSERT(one.rest == other.rest);
    for (std::size_t f = 0; f < one.triangles.size(); ++f) {
        const MembraneTriangle &a = one.triangles[f].membrane, &b = other.triangles[f].membrane;
        RC_ASSERT(a.area == b.area);
        RC_ASSERT((a.elasticity - b.elasticity).norm() <= 1e-12 * b.elasticity.norm());
    }
    RC_ASSERT(one.hinges.size() == other.hinges.size());
    for (const Edge edge : sheet.mesh().edges()) {
        const Index hinge = sheet.hinge_of_edge(edge);
        if (hinge < 0) continue;
        const HingeStencil &a = one.hinges[hinge], &b = other.hinges[anew.hinge_of_edge(edge)];
        RC_ASSERT(a.vertices == b.vertices);
        RC_ASSERT(a.rest.angle == b.rest.angle);
        RC_ASSERT(a.rest.area == b.rest.area);
        RC_ASSERT(std::abs(a.stiffness - b.stiffness) <= 1e-12 * b.stiffness);
        RC_ASSERT(std::abs(sheet.strength(edge) - anew.strength(edge)) <= 1e-12 * anew.strength(edge));
    }
}

Positions waved(const Positions& rest, double size) {
    Positions x = rest;
    for (Index v = 0; v < x.cols(); ++v) {
        const Vector3d p = rest.col(v);
        x.col(v) += size * Vector3d(std::sin(3 * p.y()), p.x() * p.z(), std::cos(2 * p.x() + p.y()));
    }
    return x;
}

/// Lets another edge fail at each vertex with more than one failed closed edge. A failed edge that has been
/// cut there opens then.
void open_cut_edges(BreakableShell& sheet) {
    for (std::size_t i = 0; i < sheet.mesh().number_of_vertices(); ++i) {
        const Mesh& mesh = sheet.mesh();
        int failed = 0;
        Edge other;
        for (const Halfedge h :
             mesh.halfedges_around_target(mesh.halfedge(Vertex(static_cast<unsigned>(i))))) {
            const EdgeState state = sheet.cracks().state(mesh.edge(h));
            failed += state == EdgeState::fractured_interior;
            if (state == EdgeState::interior) other = mesh.edge(h);
        }
        if (failed > 1 && other.is_valid()) sheet.fail(std::array{other});
    }
}

RC_GTEST_PROP(BreakableShellAdvance, IsASheetMadeOfItsMeshWhateverFails, ()) {
    const unsigned shape = *rc::gen::inRange(0u, test::sheet_shapes), seed = *rc::gen::inRange(0u, 1u << 30);
    const SheetInput input = test::directed_input(shape, seed);
    BreakableShell sheet({input});
    test::Advances advances(sheet, seed + 1);
    const double mass = sheet.mechanics().mass.sum(), footprint = sheet.mechanics().footprint.sum();
    for (int i = 0; i < 20; ++i) {
        const auto advanced = advances.next();
        expect_made_of_its_mesh(sheet);
        if (advanced && advances.random_bool()) advances.fail(advanced->halfedge);
        expect_made_of_its_mesh(sheet);
    }
    open_cut_edges(sheet);
    expect_made_of_its_mesh(sheet);
    RC_ASSERT(std::abs(sheet.mechanics().mass.sum() - mass) <= 1e-12 * mass);
    if (test::is_flat_sheet(shape))
        RC_ASSERT(std::abs(sheet.mechanics().footprint.sum() - footprint) <= 1e-9 * footprint);
    const BreakableShell anew = test::rebuilt(sheet, input);
    expect_same_shell(sheet, anew);
    const Positions x = waved(sheet.mechanics().rest, 0.02);
    const double energy = CoupledBending(anew.mechanics(), {}).value(x);
    RC_ASSERT(std::abs(CoupledBending(sheet.mechanics(), {}).value(x) - energy) <= 1e-9 * energy);
    if (test::is_flat_sheet(shape)) RC_ASSERT(std::abs(anew.mechanics().mass.sum() - mass) <= 1e-12 * mass);
}

// Without cracks the contact areas, too, must be those of the mesh, also at the rim.
RC_GTEST_PROP(BreakableShellAdvance, ContactAreasAreThoseOfTheMesh, ()) {
    const unsigned shape = *rc::gen::inRange(0u, test::sheet_shapes), seed = *rc::gen::inRange(0u, 1u << 30);
    const SheetInput input = test::directed_input(shape, seed);
    BreakableShell sheet({input});
    test::Advances advances(sheet, seed + 1);
    for (int i = 0; i < 20; ++i) advances.next();
    const VectorXd anew = test::rebuilt(sheet, input).mechanics().footprint;
    RC_ASSERT((sheet.mechanics().footprint - anew).cwiseAbs().maxCoeff() <= 1e-12 * anew.maxCoeff());
}

// The parts of each face of the unfractured mesh must have all of its mass together.
RC_GTEST_PROP(BreakableShellAdvance, KeepsTheMassOfEachFace, ()) {
    const unsigned shape = *rc::gen::inRange(0u, test::sheet_shapes), seed = *rc::gen::inRange(0u, 1u << 30);
    BreakableShell sheet({test::directed_input(shape, seed)});
    test::Advances advances(sheet, seed + 1);
    const std::vector<double> start = sheet.mechanics().face_mass;
    std::vector<std::map<Index, double>> parts;  // kg in each face, from each face of the unfractured mesh
    for (std::size_t f = 0; f < start.size(); ++f) parts.push_back({{static_cast<Index>(f), start[f]}});
    for (int i = 0; i < 15; ++i) {
        const auto advanced = advances.next();
        if (!advanced) continue;
        const std::vector<std::map<Index, double>> before = parts;
        parts.resize(sheet.mechanics().triangles.size());
        for (const auto& [face, shares] : advanced->change.shell.reshaped) {
            parts[face].clear();
            for (const auto& [parent, share] : shares)
                for (const auto& [ancestor, mass] : before[parent]) parts[face][ancestor] += share * mass;
        }
    }
    std::vector<double> sums(start.size(), 0);
    for (std::size_t f = 0; f < parts.size(); ++f) {
        double sum = 0;
        for (const auto& [ancestor, mass] : parts[f]) {
            sum += mass;
            sums[ancestor] += mass;
        }
        RC_ASSERT(std::abs(sum - sheet.mechanics().face_mass[f]) <= 1e-12 * sum);
    }
    for (std::size_t f = 0; f < start.size(); ++f)
        RC_ASSERT(std::abs(sums[f] - start[f]) <= 1e-12 * start[f]);
}

/// Mass, kg, first moment, kg m, and linear momentum, kg m/s, of the vertices of a change.
struct PatchMass {
    double mass = 0;
    Vector3d moment = Vector3d::Zero(), linear = Vector3d::Zero();

    void add(double of_vertex, const Vector3d& place, const Vector3d& velocity) {
        mass += of_vertex;
        moment += of_vertex * place;
        linear += of_vertex * velocity;
    }
};

// If momentum changed, fragments would fly or spin by themselves. Where a sheet is curved or uneven, other
// triangles have another centre of mass, and the angular momentum about the origin changes by the
// displacement of this centre; on other sheets it must not change.
RC_GTEST_PROP(BreakableShellAdvance, KeepsMomentumOfAMovingSheet, ()) {
    const unsigned shape = *rc::gen::inRange(0u, test::sheet_shapes), seed = *rc::gen::inRange(0u, 1u << 30);
    const bool is_bent = *rc::gen::arbitrary<bool>();
    BreakableShell sheet({test::directed_input(shape, seed)});
    Shell& shell = sheet.mechanics();
    test::Random random(seed + 2);
    if (is_bent) shell.position = waved(shell.rest, 0.1);
    for (double& v : shell.velocity.reshaped()) v = random.uniform(-1, 1);
    test::Advances advances(sheet, seed + 1);
    const Vector3d linear = linear_momentum(shell);
    Vector3d angular = angular_momentum(shell);
    for (int i = 0; i < 10; ++i) {
        const Shell before = shell;
        const auto advanced = advances.next();
        if (!advanced) continue;
        PatchMass then, now;
        for (const auto& [v, mass] : advanced->change.shell.weights) {
            then.add(mass, before.position.col(v), before.velocity.col(v));
            now.add(shell.mass[v], shell.position.col(v), shell.velocity.col(v));
        }
        for (const IndexWithParents& inserted : advanced->change.shell.vertices)
            now.add(shell.mass[inserted.element], shell.position.col(inserted.element),
                    shell.velocity.col(inserted.element));
        const Vector3d way =
            then.mass > 0 ? Vector3d((now.moment - then.moment) / then.mass) : Vector3d(0, 0, 0);
        RC_ASSERT(is_bent || !test::is_flat_sheet(shape) || shell.uneven || way.norm() <= 1e-14);
        angular += way.cross(then.linear);
        if (advances.random_bool()) advances.fail(advanced->halfedge);
        RC_ASSERT((linear_momentum(shell) - linear).norm() <= 1e-12 * shell.mass.sum());
        RC_ASSERT((angular_momentum(shell) - angular).norm() <= 1e-12 * shell.mass.sum());
    }
}

// If the momentum of held vertices were given to one or two free vertices beside them, these would fly off:
// a window struck by a ball at 5 m/s got a vertex of 10 km/s.
RC_GTEST_PROP(BreakableShellAdvance, NothingFliesOffBesideASupport, ()) {
    const unsigned shape = *rc::gen::inRange(0u, test::sheet_shapes), seed = *rc::gen::inRange(0u, 1u << 30);
    BreakableShell sheet({test::directed_input(shape, seed)});
    Shell& shell = sheet.mechanics();
    test::Random random(seed + 2);
    for (Index v = 0; v < shell.velocity.cols(); ++v) {
        shell.fixed[v] = random.uniform(0, 1) < 0.7;
        for (double& entry : shell.velocity.col(v)) entry = shell.fixed[v] ? 0 : random.uniform(-1, 1);
    }
    test::Advances advances(sheet, seed + 1);
    for (int i = 0; i < 10; ++i) {
        const double fastest = shell.velocity.colwise().norm().maxCoeff();
        if (!advances.next()) continue;
        RC_ASSERT(shell.velocity.colwise().norm().maxCoeff() < 2 * fastest);
        for (Index v = 0; v < shell.velocity.cols(); ++v)
            RC_ASSERT(shell.fixed[v] == 0 || shell.velocity.col(v).isZero(0));
    }
}

// A sheet in translation must keep its velocity exactly, without stretching or bending. With other triangles
// a rotating sheet has other moments of inertia, and so slightly different velocities at the same momentum.
RC_GTEST_PROP(BreakableShellAdvance, ARigidMotionStaysOne, ()) {
    const unsigned shape = *rc::gen::inRange(0u, test::sheet_shapes), seed = *rc::gen::inRange(0u, 1u << 30);
    for (const bool turns : {false, true}) {
        SheetInput input = test::directed_input(shape, seed);
        const Vector3d flight(3, -1, 2), spin = turns ? Vector3d(1, 2, -1) : Vector3d(0, 0, 0);
        input.velocity = flight;
        input.spin = spin;
        BreakableShell sheet({input});
        Shell& shell = sheet.mechanics();
        const Vector3d centre = shell.position * shell.mass / shell.mass.sum();
        test::Advances advances(sheet, seed + 1);
        for (int i = 0; i < 10; ++i) {
            const auto advanced = advances.next();
            if (advanced && advances.random_bool()) advances.fail(advanced->halfedge);
        }
        RC_ASSERT((shell.position - shell.rest).cwiseAbs().maxCoeff() <= 1e-14);
        RC_ASSERT(MembraneEnergy(shell.triangles).value(shell.position) <= 1e-18);
        const double size =
            std::sqrt(2 * shell.footprint.sum() / static_cast<double>(shell.triangles.size()));
        for (Index v = 0; v < shell.rest.cols(); ++v) {
            const Vector3d rigid = flight + spin.cross(Vector3d(shell.position.col(v)) - centre);
            RC_ASSERT((shell.velocity.col(v) - rigid).norm() <= spin.norm() * size + 1e-12);
        }
    }
}

// A linear deformation of a plane is the same in all triangles: it must store the same energy in any
// triangles.
RC_GTEST_PROP(BreakableShellAdvance, ALinearDeformationStoresWhatItDid, ()) {
    const unsigned seed = *rc::gen::inRange(0u, 1u << 30);
    SheetInput input = test::directed_input(0, seed);
    input.axes.assign(input.axes.size(), Vector3d(0.6, 0.8, 0));
    BreakableShell sheet({input});
    Shell& shell = sheet.mechanics();
    Matrix3d map;
    map << 1.1, 0.02, 0, -0.1, 0.95, 0.3, 0.1, 0, 1;
    shell.position = map * shell.rest;
    const double energy = MembraneEnergy(shell.triangles).value(shell.position);
    test::Advances advances(sheet, seed + 1);
    for (int i = 0; i < 15; ++i) {
        const auto advanced = advances.next();
        if (advanced && advances.random_bool()) advances.fail(advanced->halfedge);
    }
    RC_ASSERT((shell.position - map * shell.rest).cwiseAbs().maxCoeff() <= 1e-13);
    RC_ASSERT(std::abs(MembraneEnergy(shell.triangles).value(shell.position) - energy) <= 1e-11 * energy);
}

// Supported vertices and those of lock_vertices() must stay, and the faces of a loaded area must keep its
// mass on their side of the border. (On a curved sheet areas are shared in a plane, where the border may
// have a bend.)
RC_GTEST_PROP(BreakableShellAdvance, WhatIsKeptStays, ()) {
    const unsigned shape = *rc::gen::inRange(0u, test::sheet_shapes), seed = *rc::gen::inRange(0u, 1u << 30);
    SheetInput input = test::directed_input(shape, seed);
    input.pinned = {0, 7};
    BreakableShell sheet({input});
    Shell& shell = sheet.mechanics();
    const std::vector<Index> kept{3, 11};
    sheet.lock_vertices(kept);
    std::vector<Index> pressed;
    for (Index f = 0; f < static_cast<Index>(shell.triangles.size()); ++f)
        if (shell.rest(0, shell.triangles[f].vertices[0]) < 0.3) pressed.push_back(f);
    sheet.lock_border(pressed);
    const auto mass = [&] {
        double sum = 0;
        for (const Index face : pressed) sum += shell.face_mass[face];
        return sum;
    };
    const Shell before = shell;
    const double pressed_mass = mass();
    test::Advances advances(sheet, seed + 1);
    for (int i = 0; i < 12; ++i) {
        std::vector<Vertex> cracked;
        for (const Vertex v : sheet.mesh().vertices())
            if (sheet.cracks().is_cracked(v)) cracked.push_back(v);
        const Positions rest = shell.rest;
        const auto advanced = advances.next();
        for (const Vertex v : cracked) RC_ASSERT(shell.rest.col(v) == rest.col(v));
        if (!advanced) continue;
        follow_faces(advanced->change.shell, pressed);
        RC_ASSERT(std::abs(mass() - pressed_mass) <=
                  (test::is_flat_sheet(shape) ? 1e-12 : 1e-4) * pressed_mass);
        if (advances.random_bool()) advances.fail(advanced->halfedge);
    }
    for (const Index v : {0, 7, 3, 11}) RC_ASSERT(shell.rest.col(v) == before.rest.col(v));
    for (const Index v : {0, 7}) RC_ASSERT(shell.velocity.col(v).isZero(0));
}

/// Flat sheet whose vertices are held in its plane, and in its middle also along y.
BreakableShell held_sheet(unsigned seed) {
    SheetInput input;
    input.mesh = generate_rectangle(1, 1, {0.08, Layout::delaunay, seed});
    input.material = {.density = 1000, .thickness = 0.01, .young = 1e9, .poisson = 0.3};
    BreakableShell sheet({input});
    Shell& shell = sheet.mechanics();
    shell.guides = {Vector3d(1, 1, 0).asDiagonal(), Vector3d(1, 0, 0).asDiagonal()};
    shell.support_sets = {{{0, Vector3d(0, 0, 1).asDiagonal()}}, {{0, Vector3d(0, 1, 1).asDiagonal()}}};
    for (std::size_t v = 0; v < shell.guide.size(); ++v) {
        const bool middle = (shell.rest.col(static_cast<Index>(v)) - Vector3d(0.5, 0.5, 0)).norm() < 0.15;
        shell.guide[v] = middle ? 2 : 1;
        shell.support_set[v] = middle ? 2 : 1;
    }
    return sheet;
}

// In a sheet that is held in its plane everywhere, like one that may not buckle, vertices must move aside
// for a crack's path as in a free sheet. Where a region with another support begins they must stay, and
// inserted vertices must be held like the vertices around them.
TEST(BreakableShellAdvance, WhatIsHeldAllAlikeMovesAlong) {
    for (const unsigned seed : {1u, 2u, 3u}) {
        BreakableShell sheet = held_sheet(seed);
        const Shell before = sheet.mechanics();
        Vertex tip = sheet.mesh().target(sheet.mesh().halfedge(Face(7u)));
        int moved = 0;
        for (int i = 0; i < 12; ++i) {
            const auto made = sheet.advance(tip, {std::cos(0.5 * i), std::sin(0.5 * i), 0}, {});
            if (!made) break;
            moved += made->way != AdvancedEdge::Way::existing;
            tip = sheet.mesh().target(made->halfedge);
        }
        EXPECT_GT(moved, 3);
        const Shell& now = sheet.mechanics();
        for (Index v = 0; v < now.rest.cols(); ++v) {
            EXPECT_NE(now.guide[v], 0);
            EXPECT_EQ(now.support_set[v], now.guide[v]);
            const bool at_border = v < before.rest.cols() && before.guide[v] == 2 &&
                                   (before.rest.col(v) - Vector3d(0.5, 0.5, 0)).norm() > 0.15 - 0.04;
            EXPECT_TRUE(!at_border || now.rest.col(v) == before.rest.col(v));
        }
    }
}

// Where a crack runs into a closed crack face (lip) of another crack, its end must not collide with that
// crack.
TEST(BreakableShellAdvance, ACrackThatMeetsAClosedCrackFaceHasNoContactThere) {
    SheetInput input;
    input.mesh = test::grid(6, 6);
    input.material = {.density = 1000, .thickness = 0.01, .young = 1e9, .poisson = 0.3};
    BreakableShell sheet({input});
    std::vector<Edge> crack;
    for (unsigned i = 22; i < 25; ++i)
        crack.push_back(sheet.mesh().edge(sheet.mesh().halfedge(Vertex(i), Vertex(i + 1))));
    sheet.fail(crack);
    const auto met = sheet.advance(Vertex(15u), {0.4, 1, 0}, {});
    ASSERT_TRUE(met);
    const Vertex end = sheet.mesh().target(met->halfedge);
    ASSERT_TRUE(sheet.mesh().is_border(end));
    EXPECT_DOUBLE_EQ(position(sheet.mesh(), end).y(), 3);
    int exempt_pairs = 0;
    for (const auto& [a, b] : sheet.mechanics().exempt_pairs)
        exempt_pairs += a == static_cast<Index>(end) || b == static_cast<Index>(end);
    EXPECT_EQ(exempt_pairs, 2);
    int tips = 0;
    for (const Vertex v : sheet.mesh().vertices()) tips += sheet.cracks().is_tip(v);
    EXPECT_EQ(tips, 2);
}

}  // namespace
}  // namespace sherd
