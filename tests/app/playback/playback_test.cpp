// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/playback/playback.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "app/playback/interpolation.h"
#include "app/playback/slow_motion.h"
#include "core/elements/membrane.h"
#include "meshops/error.h"
#include "tests/support/program/temporary_directory.h"
#include "tests/support/recording/split_run.h"
#include "tests/support/recording/synthetic_run.h"

namespace sherd::test {
namespace {

using Shares = std::vector<double>;

TEST(SlowMotion, ShowsShortRunsFourToTenSecondsByARoundFactor) {
    EXPECT_EQ(default_slowdown(0.03), 200) << "6 s";
    EXPECT_EQ(default_slowdown(0.04), 100) << "4 s, whatever round-off says";
    EXPECT_EQ(default_slowdown(0.3), 20);
    EXPECT_EQ(default_slowdown(1), 5);
    EXPECT_EQ(default_slowdown(1e-5), 500'000);
    for (double seconds = 1e-6; seconds < 4; seconds *= 1.0173) {
        const double factor = default_slowdown(seconds);
        EXPECT_GE(seconds * factor, 3.999'999) << seconds;
        EXPECT_LE(seconds * factor, 10) << seconds;
        const double digit = factor / std::pow(10, std::floor(std::log10(factor) + 1e-9));
        EXPECT_TRUE(std::abs(digit - 1) < 1e-9 || std::abs(digit - 2) < 1e-9 || std::abs(digit - 5) < 1e-9)
            << factor;
    }
}

TEST(SlowMotion, NeverHurriesByItself) {
    for (const double seconds : {4.0, 17.0, 3600.0, 0.0}) EXPECT_EQ(default_slowdown(seconds), 1) << seconds;
}

TEST(SlowMotion, SaysWhichFactorItIs) {
    EXPECT_EQ(pace_of({}, 0.03).words(), "200 times slower than reality: 0.03 s last 6 s");
    EXPECT_EQ(pace_of({1, {}}, 0.03).words(), "in real time: 0.03 s last 0.03 s");
    EXPECT_EQ(pace_of({0.5, {}}, 3).words(), "2 times faster than reality: 3 s last 1.5 s");
}

TEST(SlowMotion, RefusesWhatIsNoFactorOrRate) {
    for (const double bad : {0.0, -3.0, std::nan(""), std::numeric_limits<double>::infinity()}) {
        EXPECT_THROW(check_slow_motion({bad, {}}), Error) << bad;
        EXPECT_THROW(check_slow_motion({{}, bad}), Error) << bad;
    }
    check_slow_motion({1e6, 24});
}

Shares shares(const std::vector<PlaybackTime>& moments) {
    Shares shares;
    for (const PlaybackTime& moment : moments)
        shares.push_back(static_cast<double>(moment.earlier) + moment.share);
    return shares;
}

void expect_near(const Shares& found, const Shares& expected) {
    ASSERT_EQ(found.size(), expected.size());
    for (std::size_t i = 0; i < found.size(); ++i) EXPECT_NEAR(found[i], expected[i], 1e-9) << i;
}

// Computed by hand, for frames 0, 1 and 2 at 0 s, 0.1 s and 0.3 s.
TEST(Moments, LieEvenlyInTimeBetweenTheFramesAroundThem) {
    const std::vector<std::size_t> frames{0, 1, 2};
    const std::vector<double> times{0, 0.1, 0.3};
    const std::vector<PlaybackTime> moments = even_times(frames, times, 0.05);
    expect_near(shares(moments), {0, 0.5, 1, 1.25, 1.5, 1.75, 2});
    for (std::size_t i = 0; i < moments.size(); ++i) EXPECT_NEAR(moments[i].time, 0.05 * i, 1e-12);
    EXPECT_EQ(moments[2].share, 0) << "a frame's own time is that frame, whatever round-off says";
    EXPECT_EQ(moments[2].earlier, 1u);
    EXPECT_EQ(moments[1].later, 1u);
    expect_near(shares(even_times(frames, times, 0.08)), {0, 0.8, 1.3, 1.7, 2});
}

TEST(Moments, EndWithTheLastFrame) {
    const std::vector<std::size_t> frames{3, 5, 9};
    const std::vector<double> times{1, 2, 4};
    const auto moments = even_times(frames, times, 1.5);
    ASSERT_EQ(moments.size(), 3u);
    EXPECT_EQ(moments[1].earlier, 5u);
    EXPECT_EQ(moments[1].later, 9u);
    EXPECT_NEAR(moments[1].share, 0.25, 1e-12);
    EXPECT_EQ(moments[2].earlier, 9u);
    EXPECT_EQ(moments[2].time, 4);
    EXPECT_EQ(even_times(frames, times, 100).size(), 2u);
    EXPECT_EQ(even_times(frames, std::vector<double>{1, 1, 1}, 0.1).size(), 1u);
    EXPECT_EQ(even_times(std::vector<std::size_t>{7}, std::vector<double>{2}, 0.1).size(), 1u);
}

TEST(Moments, AreNotTooMany) {
    const std::vector<std::size_t> frames{0, 1};
    const std::vector<double> times{0, 1};
    EXPECT_EQ(even_times(frames, times, 1e-4).size(), 10'001u);
    EXPECT_THROW(even_times(frames, times, 1e-9), Error);
    EXPECT_THROW(even_times(frames, times, 0), Error);
}

/// Two triangles that share the edge from 1 to 2, and these triangles torn apart there: vertices 4 and 5 are
/// the copies of 1 and 2.
std::array<Snapshot, 2> torn_pair() {
    Snapshot whole;
    whole.time = 1;
    whole.step = 10;
    whole.position.resize(3, 4);
    whole.position << 0, 1, 1, 2,  //
        0, 0, 1, 0,                //
        0, 0, 0, 0;
    whole.velocity = Positions::Zero(3, 4);
    whole.mass = VectorXd::Ones(4);
    whole.original = {0, 1, 2, 3};
    whole.faces = {{0, 1, 2}, {1, 3, 2}};
    whole.face_fragment = whole.face_sheet = {0, 0};
    whole.edges = {{1, 2}, {0, 1}};
    whole.edge_state = {EdgeState::interior, EdgeState::boundary};
    whole.edge_strain = {8, 0};
    whole.rest = unfractured_mesh(whole.position, whole.faces, {0.5, 0.5}, {0.001, 0.001});
    Snapshot torn = whole;
    torn.time = 2;
    torn.step = 20;
    torn.position.resize(3, 6);
    torn.position << 0, 1, 1, 4, 3, 3,  // the right triangle has moved 2 m to the right,
        0, 0, 1, 0, 0, 1,               //
        1, 1, 1, 0, 0, 0;               // the left one 1 m up
    torn.velocity = Positions::Constant(3, 6, 4);
    torn.mass = VectorXd::Ones(6);
    torn.original = {0, 1, 2, 3, 1, 2};
    torn.faces = {{0, 1, 2}, {4, 3, 5}};
    torn.face_fragment = {0, 1};
    torn.edges = {{1, 2}, {0, 1}, {4, 5}};
    torn.edge_state = {EdgeState::boundary, EdgeState::boundary, EdgeState::boundary};
    torn.edge_strain = {0, 0, 0};
    return {whole, torn};
}

// No face may be stretched over the crack, and nothing may jump when the later frame is reached.
TEST(Interpolation, OpensACrackFromClosedAlongStraightLines) {
    const auto [whole, torn] = torn_pair();
    const Snapshot between = interpolated(whole, torn, 0.25);
    Positions expected(3, 6);
    expected << 0, 1, 1, 2.5, 1.5, 1.5,  //
        0, 0, 1, 0, 0, 1,                //
        0.25, 0.25, 0.25, 0, 0, 0;
    EXPECT_TRUE(between.position.isApprox(expected, 1e-15)) << between.position;
    EXPECT_EQ(between.faces, torn.faces);
    EXPECT_EQ(between.original, torn.original);
    EXPECT_TRUE(between.velocity.isApprox(Positions::Constant(3, 6, 1)));
    EXPECT_EQ(between.time, 1.25);
    EXPECT_LT((interpolated(whole, torn, 1 - 1e-9).position - torn.position).norm(), 1e-8);
    const Snapshot first = interpolated(whole, torn, 1e-9);
    EXPECT_LT((first.position.col(4) - first.position.col(1)).norm(), 1e-8) << "closed at first";
}

TEST(Interpolation, CountsAPieceFromTheLaterFrameOn) {
    const auto [whole, torn] = torn_pair();
    const Snapshot between = interpolated(whole, torn, 0.9);
    EXPECT_EQ(between.face_fragment, whole.face_fragment);
    EXPECT_EQ(between.edge_state[0], EdgeState::interior) << "it breaks at the later frame";
    EXPECT_EQ(between.edge_strain[0], 8);
    EXPECT_EQ(between.edge_state[2], EdgeState::boundary);
    EXPECT_EQ(between.step, 10);
}

TEST(Interpolation, FollowsTheStrainOfHingesThatStay) {
    auto [whole, torn] = torn_pair();
    Snapshot bent = whole;
    bent.edge_strain[0] = -4;
    EXPECT_EQ(interpolated(whole, bent, 0.25).edge_strain[0], 5);
    torn.faces.pop_back();
    EXPECT_THROW(interpolated(whole, torn, 0.5), Error) << "not frames of one run";
}

// A wheel rolls: its centre must move on a straight line, although the origin of its own frame is on its rim.
TEST(Interpolation, TurnsABodyAboutItsMiddle) {
    const Vector3d middle(0, 0, 1);
    const auto pose = [&](double angle, const Vector3d& place) {
        return Eigen::Isometry3d(Eigen::Translation3d(place) * Eigen::AngleAxisd(angle, Vector3d::UnitY()) *
                                 Eigen::Translation3d(-middle));
    };
    const double angle = 0.8 * std::numbers::pi;
    const Eigen::Isometry3d between = interpolated(pose(0, {0, 0, 1}), pose(angle, {4, 0, 1}), 0.25, middle);
    EXPECT_TRUE(between.isApprox(pose(angle / 4, {1, 0, 1}), 1e-12)) << between.matrix();
    Eigen::Isometry3d lost = pose(0, {1, 1, 1});
    lost.translation().x() = std::nan("");
    EXPECT_EQ(interpolated(pose(0, {0, 0, 1}), lost, 0.5, middle).matrix(), pose(0, {0, 0, 1}).matrix());
}

// A film has some twenty pictures between two frames, for which these must not be read again.
TEST(Playback, ReadsEachFrameOnce) {
    const auto pair = torn_pair();
    std::vector<std::size_t> read;
    Playback playback([&](std::size_t number) {
        read.push_back(number);
        Snapshot frame = pair[number % 2];
        frame.faces = pair[0].faces;
        return frame;
    });
    const std::vector<std::size_t> frames{0, 1, 2};
    const std::vector<double> times{0, 1, 2};
    for (const PlaybackTime& moment : even_times(frames, times, 0.1)) playback.at(moment);
    EXPECT_EQ(read, frames);
    EXPECT_EQ(playback.at({2, 2, 0, 2}).position, pair[0].position) << "a frame is what was recorded";
}

// Sheets that move smoothly would pass through an obstacle that jumps from frame to frame.
TEST(Playback, MovesObstaclesBetweenFrames) {
    const TemporaryDirectory folder;
    const SyntheticRun run = synthetic_run();
    const RecordedObstacle anvil{"anvil",
                                 {{{1, 0, 0}, {2, 0, 0}, {1, 2, 0}, {1, 0, 3}}, {{0, 2, 1}, {0, 1, 3}}}};
    {
        RecordingWriter writer(folder.path / "run.h5", run.header, false, {{anvil}});
        for (std::size_t k = 0; k < 2; ++k) {
            const Eigen::Isometry3d pose(Eigen::Translation3d(2.0 * static_cast<double>(k), 0, 0) *
                                         Eigen::AngleAxisd(0.4 * static_cast<double>(k), Vector3d::UnitX()));
            writer.append(run.frames[k], run.steps[k], run.events[k], {{pose}});
        }
    }
    const Recording recording(folder.path / "run.h5");
    EXPECT_EQ(recording.time(1), run.frames[1].time);
    const ObstaclePlayback obstacles(recording);
    const Eigen::Isometry3d between = obstacles.at({0, 1, 0.25, 0.025})[0];
    const Eigen::AngleAxisd turned(between.rotation());
    EXPECT_NEAR(turned.angle(), 0.1, 1e-12);
    const Vector3d middle(1.25, 0.5, 0.75), goal = recording.poses(1)[0] * middle;
    EXPECT_LT((between * middle - (middle + 0.25 * (goal - middle))).norm(), 1e-12);
    EXPECT_EQ(obstacles.at({1, 1, 0, 0.1})[0].matrix(), recording.poses(1)[0].matrix());
}

TEST(Interpolation, FieldsOfFacesGoStraight) {
    SyntheticRun run = synthetic_run();
    add_fields(run);
    run.frames[1].fields.stress_top *= -3;
    const Snapshot between = interpolated(run.frames[0], run.frames[1], 0.25);
    const Eigen::Matrix3Xd& from = run.frames[0].fields.stress_top;
    EXPECT_LT((between.fields.stress_top - (from + 0.25 * (-3 * from - from))).norm(), 1e-12 * from.norm());
    EXPECT_TRUE(choice_of(between.fields).curvature);
}

// A tensor that is constant in space and time has different components in each part of a split face, since
// the parts have different axes.
TEST(Interpolation, FieldsTurnIntoTheAxesOfPartsOfFaces) {
    const SyntheticRun run = split_run();
    Eigen::Matrix2d tensor;
    tensor << 3, 1, 1, -2;
    std::vector<Snapshot> frames(run.frames.begin(), run.frames.end());
    for (Snapshot& frame : frames) {
        frame.fields.stress_top.resize(3, static_cast<Eigen::Index>(frame.faces.size()));
        frame.fields.curvature = frame.fields.stress_top;
        for (std::size_t f = 0; f < frame.faces.size(); ++f) {
            const Eigen::Matrix2d axes =
                frame_axes(columns(frame.rest.position, frame.rest.faces[f])).topRows<2>();
            const Eigen::Matrix2d local = axes.transpose() * tensor * axes;
            const auto column = static_cast<Eigen::Index>(f);
            frame.fields.stress_top.col(column) << local(0, 0), local(1, 1), local(0, 1);
            frame.fields.curvature.col(column) << local(0, 0), local(1, 1), 2 * local(0, 1);
        }
        frame.fields.stress_bottom = frame.fields.stress_top;
    }
    for (std::size_t k = 0; k + 1 < frames.size(); ++k) {
        const Snapshot between = interpolated(frames[k], frames[k + 1], 0.3);
        EXPECT_LT((between.fields.stress_top - frames[k + 1].fields.stress_top).norm(), 1e-12) << k;
        EXPECT_LT((between.fields.curvature - frames[k + 1].fields.curvature).norm(), 1e-12) << k;
    }
}

}  // namespace
}  // namespace sherd::test
