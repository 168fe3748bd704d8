// SPDX-License-Identifier: GPL-3.0-or-later
// With wrong thicknesses, a sheet of uneven thickness would weigh, bend or fracture like a sheet of another
// thickness.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "fracture/record/snapshot.h"
#include "fracture/shell/hinge_measures.h"
#include "meshops/error.h"
#include "meshops/generate/generate.h"
#include "tests/support/program/message_thrown_by.h"
#include "tests/support/shell/advanced_sheet.h"
#include "tests/support/shell/materials.h"

namespace sherd {
namespace {

SheetInput tapered_strip() {
    SheetInput input;
    input.mesh = generate_rectangle(0.3, 0.1, {.edge_length = 0.02});
    input.material = test::ceramic;
    for (const Vertex v : input.mesh.vertices())
        input.thickness.push_back(test::linear_thickness(position(input.mesh, v)));
    return input;
}

TEST(UnevenSheet, WeighsWhatItsVolumeDoes) {
    const BreakableShell sheet({tapered_strip()});
    const double volume = 0.3 * 0.1 * test::linear_thickness({0.15, 0.05, 0});
    EXPECT_NEAR(sheet.mechanics().mass.sum(), volume * test::ceramic.density, 1e-12 * volume);
}

TEST(UnevenSheet, StretchesAndBendsAsThickAsItIsThere) {
    const BreakableShell sheet({tapered_strip()});
    const Shell& shell = sheet.mechanics();
    const auto at = [&](const auto& vertices) {
        Material local = test::ceramic;
        local.thickness = test::linear_thickness(columns(shell.rest, vertices).rowwise().mean());
        return local;
    };
    for (const auto& [vertices, membrane] : shell.triangles) {
        const double expected = membrane_elasticity(at(vertices))(0, 0);
        EXPECT_NEAR(membrane.elasticity(0, 0), expected, 1e-12 * expected);
    }
    for (const HingeStencil& hinge : shell.hinges) {
        const double expected = hinge_stiffness(at(hinge.vertices));
        EXPECT_NEAR(hinge.stiffness, expected, 1e-12 * expected);
    }
}

TEST(UnevenSheet, IsRecordedWithTheThicknessOfEachFace) {
    const BreakableShell sheet({tapered_strip()});
    const Snapshot snapshot =
        take_snapshot(sheet, std::vector<Index>(sheet.mesh().number_of_faces(), Index{0}));
    for (const Face face : sheet.mesh().faces())
        EXPECT_NEAR(snapshot.rest.thickness[face], test::linear_thickness(centroid(sheet.mesh(), face)),
                    1e-15);
}

// Under a uniform strain the stress, the force over the local thickness, must be the same at thick and thin
// places.
TEST(UnevenSheet, StressIsForceOverTheLocalThickness) {
    const BreakableShell sheet({tapered_strip()});
    const Shell& shell = sheet.mechanics();
    Positions x = shell.rest;
    x.row(0) *= 1.001;
    const HingeMeasures measures = hinge_measures(sheet, x, {}, {});
    for (std::size_t h = 0; h < shell.hinges.size(); ++h) {
        const Vector3d edge =
            shell.rest.col(shell.hinges[h].vertices[1]) - shell.rest.col(shell.hinges[h].vertices[0]);
        const double cosine = std::pow(edge.normalized().y(), 2), sine = 1 - cosine;
        const double strain = 0.001 + 0.5e-6, young = test::ceramic.young / (1 - 0.04);
        EXPECT_NEAR(measures.stress[static_cast<Index>(h)], young * strain * (cosine + 0.2 * sine),
                    0.02 * young * strain);
    }
}

// A crack that moves vertices and cuts faces must keep the thickness of the sheet at each place.
RC_GTEST_PROP(UnevenSheet, IsAsThickAsBeforeInEachPlaceWhateverCracks, ()) {
    const unsigned shape = *rc::gen::elementOf(std::vector<unsigned>{0, 3, 4}),
                   seed = 2 * *rc::gen::inRange(0u, 1u << 29) + 1;
    BreakableShell sheet({test::directed_input(shape, seed)});
    RC_ASSERT(sheet.mechanics().uneven);
    test::Advances advances(sheet, seed + 1);
    for (int i = 0; i < 20; ++i) {
        const auto advanced = advances.next();
        if (advanced && advances.random_bool()) advances.fail(advanced->halfedge);
    }
    const Shell& shell = sheet.mechanics();
    for (Index v = 0; v < static_cast<Index>(shell.rest.cols()); ++v)
        RC_ASSERT(std::abs(shell.thickness[v] - test::linear_thickness(shell.rest.col(v))) < 1e-12);
}

TEST(UnevenSheet, RefusesAThicknessThatIsMissingOrNone) {
    SheetInput input = tapered_strip();
    const auto message = [&] { return test::message_thrown_by([&] { BreakableShell({input}); }); };
    for (const double bad : {0.0, -1e-3, std::nan("")}) {
        input.thickness[4] = bad;
        EXPECT_NE(message().find("sheet 0: the thickness of vertex 4, "), std::string::npos) << message();
    }
    input.thickness.resize(7);
    EXPECT_NE(message().find("sheet 0: 7 thicknesses for "), std::string::npos) << message();
}

}  // namespace
}  // namespace sherd
