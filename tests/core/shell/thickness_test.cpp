// SPDX-License-Identifier: GPL-3.0-or-later
// With a wrong local thickness, a sheet of uneven thickness would have wrong stiffness or contact in places,
// or a sheet of even thickness would no longer give the same bits.
#include "core/shell/thickness.h"

#include <gtest/gtest.h>

#include "core/contact/detection/contact_surface.h"
#include "core/contact/penalty/obstacle_contact.h"
#include "core/contact/sheets/sheet_contact.h"
#include "core/shell/face_fields.h"
#include "tests/support/contact/obstacles.h"
#include "tests/support/shell/materials.h"
#include "tests/support/shell/plates.h"
#include "tests/support/shell/steps.h"

namespace sherd {
namespace {

/// Plates of 0.1 m; thickness() gives the thickness, m, of each vertex from its place at rest.
template <class Thickness>
Shell uneven_plates(int plates, int count, const Thickness& thickness) {
    Shell shell = test::stacked_plates(plates, count, 0, test::ceramic);
    shell.uneven = true;
    for (Index v = 0; v < static_cast<Index>(shell.mass.size()); ++v)
        shell.thickness[v] = thickness(Vector3d(shell.rest.col(v)));
    return shell;
}

double taper(const Vector3d& at) {
    return 2e-3 + 0.02 * at.x();  // from 1 to 3 mm
}

TEST(Thickness, MeanOfEqualOnesIsExactlyThese) {
    Shell shell = test::two_triangles(test::ceramic);
    shell.uneven = true;
    test::Random random(1);
    for (int i = 0; i < 1000; ++i) {
        const double thickness = random.uniform(1e-4, 1e-2);
        shell.thickness.setConstant(thickness);
        EXPECT_EQ(mean_thickness(shell, shell.triangles[0].vertices), thickness);
    }
}

TEST(Thickness, OfAnEvenSheetIsThatOfTheFirstVertexWhateverRoundOffMadeOfTheOthers) {
    Shell shell = test::two_triangles(test::ceramic);
    shell.thickness << 1, 2, 3, 4;
    EXPECT_EQ(mean_thickness(shell, std::array<Index, 3>{1, 2, 3}), 2);
    shell.uneven = true;
    EXPECT_EQ(mean_thickness(shell, std::array<Index, 3>{1, 2, 3}), 3);
}

// A vertex that a crack moves within the sheet must take the sheet's thickness at its new place.
TEST(Thickness, FollowsVerticesThatMoveInAnUnevenSheetOnly) {
    const ShellChange change{.vertices = {{4, {{0, 0.5}, {2, 0.5}}}}, .moved = {{0, {{0, 0.25}, {1, 0.75}}}}};
    for (const bool uneven : {false, true}) {
        Shell shell = test::two_triangles(test::ceramic);
        shell.thickness << 1, 2, 3, 4;
        shell.uneven = uneven;
        shell.face_mass = {1, 1};
        follow(shell, change);
        EXPECT_EQ(shell.thickness[0], uneven ? 1.75 : 1);
        EXPECT_EQ(shell.thickness[4], 2) << "its parents as they were";
    }
}

// The stress at a surface must follow from the local thickness: with another one a plate would fracture
// elsewhere.
TEST(Thickness, StressAtASurfaceIsOfTheLocalThickness) {
    Shell shell = test::two_triangles(test::ceramic);
    shell.uneven = true;
    shell.thickness << 1e-3, 2e-3, 3e-3, 2e-3;
    Material local = test::ceramic;
    local.thickness = 2e-3;
    shell.triangles[0].membrane.elasticity = membrane_elasticity(local);
    const Vector3d curvature(1, 0, 0);
    const FaceState state = face_state(shell, 0, Vector3d::Zero(), curvature);
    const Vector3d expected = plane_stress_elasticity(elastic_constants(local), 1) * curvature * 1e-3;
    EXPECT_LT((state.stress_bottom - expected).norm(), 1e-12 * expected.norm());
}

TEST(Thickness, ASheetTouchesAnObstacleAtHalfOfWhatItIsThere) {
    const Shell shell = uneven_plates(1, 6, taper);
    const Obstacle floor = test::obstacle(PlaneShape(Vector3d::Zero(), Vector3d::UnitZ()), 1e7, 0);
    const ObstacleContact contact = test::begun(ObstacleContact(shell, floor), shell, 0, 1e-3);
    Positions x = shell.rest;
    x.row(2) = 0.5 * shell.thickness.transpose() * (1 + 1e-9);
    EXPECT_EQ(contact.value(x), 0);
    for (Index v = 0; v < static_cast<Index>(x.cols()); ++v) {
        Positions lower = x;
        lower(2, v) -= 1e-8;
        EXPECT_GT(contact.value(lower), 0) << v;
    }
}

// Two sheets touch where their half thicknesses meet, at thin and at thick places.
TEST(Thickness, SheetsTouchAtHalfTheSumOfWhatTheyAreThere) {
    Shell shell = uneven_plates(2, 12, taper);
    const auto upper = static_cast<Index>(shell.rest.cols()) / 2;
    const auto stacked = [&](double gap) {
        Positions x = shell.rest;  // positions of the middle surfaces; the top of the lower sheet is z = 0
        for (Index v = 0; v < static_cast<Index>(x.cols()); ++v)
            x(2, v) = v < upper ? -0.5 * taper(x.col(v)) : 0.5 * shell.thickness[v] + gap;
        return x;
    };
    const double within_an_element = 0.02 * 0.1 / 12;  // m, difference of the thickness across an element
    const SheetContact contact(shell);
    EXPECT_TRUE(contact.active_pairs(stacked(within_an_element)).empty());
    const std::vector<ContactPair> active = contact.active_pairs(stacked(-2 * within_an_element));
    for (const double side : {-1.0, 1.0})
        EXPECT_TRUE(std::ranges::any_of(active, [&](const ContactPair& pair) {
            return side * shell.rest(0, pair.vertices[0]) > 0.03;
        })) << side;
}

TEST(Thickness, OfEdgesAndTrianglesInContactIsTheMeanOfTheirVertices) {
    Shell shell = uneven_plates(2, 2, taper);
    const auto& [a, b, c] = shell.triangles.front().vertices;
    const Index v = static_cast<Index>(shell.rest.cols()) - 1, w = v - 1;
    const auto& t = shell.thickness;
    EXPECT_NEAR(activation_distance_of_sheets(shell, PairKind::vertex_triangle, {v, a, b, c}),
                0.5 * (t[v] + (t[a] + t[b] + t[c]) / 3), 1e-15);
    EXPECT_NEAR(activation_distance_of_sheets(shell, PairKind::edge_edge, {a, b, w, v}),
                0.5 * ((t[a] + t[b]) / 2 + (t[v] + t[w]) / 2), 1e-15);
}

}  // namespace
}  // namespace sherd
