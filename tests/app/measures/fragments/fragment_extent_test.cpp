// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/measures/fragments/fragment_extent.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "app/measures/cracks/crack_extent.h"

namespace sherd::test {
namespace {

/// Adds a rectangle of two triangles, with the first corner at `corner`, as a fragment.
void add_rectangle(Snapshot& frame, const Vector3d& corner, const Vector3d& along, const Vector3d& across) {
    const auto first = static_cast<Index>(frame.rest.position.cols());
    frame.rest.position.conservativeResize(3, first + 4);
    frame.rest.position.rightCols(4) << corner, corner + along, corner + along + across, corner + across;
    const auto fragment = static_cast<Index>(frame.faces.size() / 2);
    for (const std::array<Index, 3>& face : {std::array<Index, 3>{first, first + 1, first + 2},
                                             std::array<Index, 3>{first, first + 2, first + 3}}) {
        frame.rest.faces.push_back(face);
        frame.faces.push_back(face);
        frame.face_fragment.push_back(fragment);
        frame.rest.area.push_back(along.cross(across).norm() / 2);
    }
}

CrackExtent extent_of(const Snapshot& frame) {
    return crack_extent(crack_graph(frame), frame.rest);
}

// Lengths along the axes of space, or along the mesh's edges, would depend on a fragment's orientation.
TEST(FragmentExtent, IsThatOfARectangleHoweverItLies) {
    Snapshot frame;
    frame.rest.position.resize(3, 0);
    const Matrix3d turn = Eigen::AngleAxisd(0.7, Vector3d(1, 2, 3).normalized()).toRotationMatrix();
    add_rectangle(frame, {0, 0, 0}, {0.1, 0, 0}, {0, 0.3, 0});
    add_rectangle(frame, turn * Vector3d(1, 2, 3), turn.col(0) * 0.02, turn.col(2) * 0.05);
    const std::vector<FragmentExtent> extents = fragment_extents(frame);
    ASSERT_EQ(extents.size(), 2u);
    EXPECT_NEAR(extents[0].length, 0.3, 1e-12);
    EXPECT_NEAR(extents[0].width, 0.1, 1e-12);
    EXPECT_NEAR(extents[1].length, 0.05, 1e-12);
    EXPECT_NEAR(extents[1].aspect_ratio(), 2.5, 1e-10);
}

// An open crack has two sides and must not count twice; a closed crack must count, too.
TEST(CrackExtent, CountsOpenAndClosedCracksOnceAndNoBoundary) {
    Snapshot frame;
    frame.rest.position.resize(3, 0);
    add_rectangle(frame, {0, 0, 0}, {0.3, 0, 0}, {0, 0.4, 0});
    add_rectangle(frame, {1, 0, 0}, {0.3, 0, 0}, {0, 0.4, 0});
    frame.rest.thickness = {0.001, 0.003, 0.001, 0.001};
    EXPECT_EQ(extent_of(frame).length, 0);
    frame.edges = {{4, 6}, {0, 1}};
    frame.edge_state = {EdgeState::fractured_interior, EdgeState::boundary};
    EXPECT_NEAR(extent_of(frame).length, 0.5, 1e-14);  // diagonal of the second rectangle
    frame.faces[1] = {8, 9, 3};                        // the first rectangle comes apart along its diagonal
    const CrackExtent both = extent_of(frame);
    EXPECT_NEAR(both.length, 1.0, 1e-14);
    EXPECT_NEAR(both.area, 0.5 * 0.001 + 0.5 * 0.002, 1e-16);
}

}  // namespace
}  // namespace sherd::test
