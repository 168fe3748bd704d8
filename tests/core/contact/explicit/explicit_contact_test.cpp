// SPDX-License-Identifier: GPL-3.0-or-later
// Contact in explicit steps. In a step forces are computed only where something may touch: what is left out
// would pass through.
#include "core/contact/explicit/explicit_contact.h"

#include <gtest/gtest.h>

#include "tests/support/contact/obstacles.h"
#include "tests/support/shell/materials.h"
#include "tests/support/shell/plates.h"

namespace sherd {
namespace {

/// Contact of the shell, with friction, with a floor and a box.
struct World {
    World(const Shell& shell, bool sheets)
        : contact(shell, options(sheets), {}, Vector3d::Zero(), Threads()) {}

    static ContactOptions options(bool sheets) {
        ContactOptions all;
        all.sheets = sheets;
        all.friction = 0.2;
        Obstacle box = test::obstacle(PlaneShape{});
        box.surface = test::box_surface(Vector3d(0, 0, -0.02), Vector3d(0.01, 0.01, 0.02));
        all.obstacles = {test::floor(), box};
        return all;
    }
    ContactForces forces(const Positions& x, const Positions& velocity, double length) {
        ContactForces all;
        contact.find_forces({length, x, velocity}, all);
        return all;
    }

    ExplicitContact contact;
};

/// Three plates that have not quite met, which move and turn against each other.
Shell approaching_plates() {
    Shell shell = test::stacked_plates(3, 6, 1.02 * test::glass.thickness, test::glass);
    shell.position.row(2).array() += 0.51 * test::glass.thickness;
    test::Random random(7);
    for (Index v = 0; v < static_cast<Index>(shell.mass.size()); ++v) {
        const double side = 1 - static_cast<double>(shell.vertex_sheet[v]);
        shell.velocity.col(v) =
            Vector3d(random.uniform(-1, 1), random.uniform(-1, 1), side * random.uniform(0, 10));
    }
    return shell;
}

TEST(ExplicitContact, LooksAtAllThatMeetsInTheStep) {
    const Shell shell = approaching_plates();
    for (const double length : {2e-6, 2e-5, 2e-4}) {
        StepContext step{0, length, length, shell.position, shell.velocity, {}};
        World ahead(shell, true), everywhere(shell, true);
        const ContactRates rates = ahead.contact.look_ahead(step);
        const Positions x = shell.position + length * shell.velocity;
        const ContactForces found = ahead.forces(x, shell.velocity, length);
        const ContactForces expected = everywhere.forces(x, shell.velocity, length);
        if (length > 1e-5) {
            EXPECT_GT(expected.force.norm(), 0);
        }
        EXPECT_LE((found.force - expected.force).norm(), 1e-12 * expected.force.norm());
        EXPECT_LE((found.friction - expected.friction).norm(), 1e-12 * expected.friction.norm());
        for (Index v = 0; v < static_cast<Index>(shell.mass.size()); ++v) {
            EXPECT_TRUE(rates.of_vertices[v] > 0 || expected.force.col(v).isZero(0)) << "vertex " << v;
        }
    }
}

// Forces of an earlier list of vertices must not stay on those that are no longer looked at.
TEST(ExplicitContact, LeavesNoForceWhereItNoLongerLooks) {
    Shell shell = approaching_plates();
    World world(shell, true);
    ContactForces forces;
    const Positions x = shell.position + 2e-4 * shell.velocity;
    world.contact.find_forces({2e-4, x, shell.velocity}, forces);
    ASSERT_GT(forces.force.norm(), 0);
    shell.position.row(2).array() += 0.1;
    for (Index v = 0; v < static_cast<Index>(shell.mass.size()); ++v)
        shell.position(2, v) += static_cast<double>(shell.vertex_sheet[v]);
    world.contact.look_ahead({0, 1e-6, 1e-6, shell.position, shell.velocity, {}});
    EXPECT_TRUE(world.contact.vertices().empty());
    world.contact.find_forces({1e-6, shell.position, shell.velocity}, forces);
    EXPECT_TRUE(forces.force.isZero(0));
    EXPECT_TRUE(forces.friction.isZero(0));
}

// Crack faces belong to the contact of sheets: without it they must not repel each other.
TEST(ExplicitContact, CrackFacesActOnlyWhereSheetsMeet) {
    Shell shell = test::stacked_plates(1, 4, 0, test::glass);
    shell.position.row(2).setConstant(0.1);
    const auto [a, b, c] = shell.triangles[0].vertices;
    const Index inside = shell.triangles[20].vertices[0];
    for (const auto& [from, to] : {std::pair{a, b}, {b, a}})
        if (crack_face_opening(columns(shell.position, std::array{inside, from, to, c})) < 0)
            shell.crack_faces = {{{inside, from, to, c}, 1e3}};
    ASSERT_EQ(shell.crack_faces.size(), 1u);
    for (const bool sheets : {false, true}) {
        World world(shell, sheets);
        for (const bool ahead : {false, true}) {
            if (ahead) world.contact.look_ahead({0, 1e-6, 1e-6, shell.position, shell.velocity, {}});
            const ContactForces found = world.forces(shell.position, shell.velocity, 1e-6);
            EXPECT_EQ(found.force.norm() > 0, sheets);
        }
    }
}

}  // namespace
}  // namespace sherd
