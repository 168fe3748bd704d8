// SPDX-License-Identifier: GPL-3.0-or-later
// Recordings of runs whose triangles change with their cracks. If a test failed, such runs could not be
// recorded, or films would tear the sheet between two frames.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "app/playback/frame_parents.h"
#include "tests/support/program/temporary_directory.h"
#include "tests/support/recording/same_snapshot.h"
#include "tests/support/shell/advanced_run.h"

namespace sherd::test {
namespace {

void expect_recorded_and_followed(unsigned shape, unsigned seed) {
    Matrix3d linear;
    linear << 1.1, 0.2, 0, -0.1, 0.9, 0.3, 0.4, 0, 1;
    std::vector<Snapshot> frames = advanced_frames(shape, seed, linear);
    for (std::size_t k = 1; k < frames.size(); k += 2)
        frames[k].edge_cohesive_share.assign(frames[k].edges.size(), 0.3);
    const TemporaryDirectory folder;
    RecordingWriter writer(folder.path / "advanced.h5", advanced_header(frames[0]), false);
    for (const Snapshot& frame : frames) writer.append(frame, {}, {});
    const Recording recording(folder.path / "advanced.h5");
    for (std::size_t k = 0; k < frames.size(); ++k) {
        const Snapshot read = recording.frame(k);
        expect_same(read, frames[k]);
        EXPECT_EQ(read.rest.face_mixed, frames[k].rest.face_mixed);
        EXPECT_EQ(read.rest.position, frames[k].rest.position);
        for (std::size_t other = 0; other < k; ++other) {
            const Positions carried =
                frame_parents(frames[other], read).interpolated_from(frames[other].position);
            const double worst = (carried - read.position).cwiseAbs().maxCoeff();
            EXPECT_LE(worst, is_flat_sheet(shape) ? 1e-9 : 0.15) << other << " to " << k;
        }
    }
}

RC_GTEST_PROP(AdvancedRecording, HoldsWhatItWasGivenAndFramesFollowEachOther, ()) {
    expect_recorded_and_followed(*rc::gen::inRange(0u, sheet_shapes), *rc::gen::inRange(0u, 1u << 30));
    RC_ASSERT(!testing::Test::HasFailure());
}

// With this seed the parent of a face at 0.5 s, whose corners are all inserted after 0.3 s, is the parent of
// no face at 0.3 s, since its parts are then in faces that have larger parts of its neighbours.
TEST(AdvancedRecording, FollowsAFaceWhoseParentHadNoFaceBefore) {
    expect_recorded_and_followed(3, 396980017);
}

// Data of the unfractured mesh are transferred to a later mesh by parents and weights, which must place each
// vertex in the unfractured mesh.
RC_GTEST_PROP(AdvancedRecording, VerticesLieInTheUnbrokenMesh, ()) {
    const unsigned shape = *rc::gen::inRange(0u, sheet_shapes), seed = *rc::gen::inRange(0u, 1u << 30);
    const RestMesh rest = advanced_frames(shape, seed, Matrix3d::Identity()).back().rest;
    for (std::size_t v = 0; v < rest.vertex_parents.size(); ++v) {
        Vector3d place = Vector3d::Zero();
        for (int k = 0; k < 3; ++k)
            place += rest.vertex_weights[v][k] * rest.unfractured_position.col(rest.vertex_parents[v][k]);
        const double off = (place - rest.position.col(static_cast<Index>(v))).norm();
        RC_ASSERT(off <= (is_flat_sheet(shape) ? 1e-12 : 0.06));
    }
    double area = 0, unbroken = 0;
    for (const double of_face : rest.area) area += of_face;
    for (const std::array<Index, 3>& face : rest.unfractured_faces) {
        const TrianglePositions x = columns(rest.unfractured_position, face);
        unbroken += Vector3d(x.col(1) - x.col(0)).cross(Vector3d(x.col(2) - x.col(0))).norm() / 2;
    }
    RC_ASSERT(std::abs(area - unbroken) <= (is_flat_sheet(shape) ? 1e-12 : 0.02) * unbroken);
}

}  // namespace
}  // namespace sherd::test
