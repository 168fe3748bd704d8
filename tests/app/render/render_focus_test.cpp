// SPDX-License-Identifier: GPL-3.0-or-later
// The camera must show the action, but not follow a lone splinter.
#include <gtest/gtest.h>

#include <limits>
#include <map>

#include "app/render/focus.h"
#include "app/render/render_stage.h"
#include "meshops/random.h"
#include "tests/support/program/temporary_directory.h"
#include "tests/support/recording/synthetic_run.h"

namespace sherd::test {
namespace {

using Eigen::AlignedBox3d;

/// Frame of square pieces of sheets.
struct Pieces {
    Snapshot frame;

    void add(const Vector3d& centre, double side, Index sheet = 0) {
        const auto first = static_cast<Index>(frame.position.cols());
        const auto fragment = static_cast<Index>(frame.faces.size() / 2);
        frame.position.conservativeResize(3, first + 4);
        for (int i = 0; i < 4; ++i)
            frame.position.col(first + i) = centre + side / 2 * Vector3d(i % 3 ? 1 : -1, i / 2 ? 1 : -1, 0);
        for (const auto& face : {std::array{first, first + 1, first + 2}, {first, first + 2, first + 3}}) {
            frame.faces.push_back(face);
            frame.face_fragment.push_back(fragment);
            frame.face_sheet.push_back(sheet);
            frame.rest.area.push_back(side * side / 2);
        }
    }

    /// Adds a hundred pieces side by side, which make up a square of 1 m about the origin.
    void add_sheet() {
        for (int i = 0; i < 10; ++i)
            for (int j = 0; j < 10; ++j) add(Vector3d(i * 0.1 - 0.45, j * 0.1 - 0.45, 0), 0.1);
    }

    AlignedBox3d focus() const { return focus_box(frame); }
};

const AlignedBox3d whole(Vector3d(-0.5, -0.5, 0), Vector3d(0.5, 0.5, 0));

void expect_same_box(const AlignedBox3d& found, const AlignedBox3d& expected) {
    EXPECT_NEAR((found.min() - expected.min()).norm() + (found.max() - expected.max()).norm(), 0, 1e-12)
        << found.min().transpose() << " to " << found.max().transpose();
}

TEST(Focus, LeavesOutASplinterThatFliesAway) {
    Pieces pieces;
    pieces.add_sheet();
    expect_same_box(pieces.focus(), whole);
    for (const double way : {3.0, 1e3, 1e9}) {
        Pieces flown = pieces;
        flown.add(Vector3d(0, way, way / 2), 0.05);
        expect_same_box(flown.focus(), whole);
    }
}

// The focus must contain all that is important: a piece just beside the rest, large pieces, and a small sheet
// far away.
TEST(Focus, HasEveryThingElse) {
    Pieces pieces;
    pieces.add_sheet();
    pieces.add(Vector3d(0.6, 0, 0), 0.1);
    EXPECT_NEAR(pieces.focus().max().x(), 0.65, 1e-12) << "beside the rest";
    pieces.add(Vector3d(0, 0, 20), 0.01, 1);
    EXPECT_NEAR(pieces.focus().max().z(), 20, 1e-12) << "another sheet";
    Pieces halves;
    halves.add(Vector3d(-30, 0, 0), 1);
    halves.add(Vector3d(40, 0, 0), 0.3);
    expect_same_box(halves.focus(), {Vector3d(-30.5, -0.5, 0), Vector3d(40.15, 0.5, 0)});
    Pieces falling;
    falling.add(Vector3d(3, 4, -1e4), 1);
    expect_same_box(falling.focus(), {Vector3d(2.5, 3.5, -1e4), Vector3d(3.5, 4.5, -1e4)});
}

// The focus must contain 19 twentieths of a sheet's area, whatever the distribution and order of its pieces.
TEST(Focus, HasNineteenTwentiethsOfASheet) {
    sherd::Random random(5);
    for (int trial = 0; trial < 200; ++trial) {
        Pieces pieces;
        const int count = 1 + static_cast<int>(random.uniform() * 40);
        for (int i = 0; i < count; ++i) {
            const double far = std::pow(10, 4 * random.uniform());
            pieces.add(far * Vector3d(random.uniform() - 0.5, random.uniform() - 0.5, random.uniform() - 0.5),
                       0.1 + random.uniform());
        }
        const AlignedBox3d focus = pieces.focus();
        double inside = 0, all = 0;
        for (std::size_t f = 0; f < pieces.frame.rest.area.size(); f += 2) {
            all += pieces.frame.rest.area[f];
            bool shown = true;
            for (Index v : pieces.frame.faces[f])
                shown &= focus.contains(Vector3d(pieces.frame.position.col(v)));
            if (shown) inside += pieces.frame.rest.area[f];
        }
        EXPECT_GE(inside, 0.95 * all - 1e-9);
        Snapshot turned = pieces.frame;
        std::ranges::reverse(turned.faces);
        std::ranges::reverse(turned.face_fragment);
        std::ranges::reverse(turned.rest.area);
        expect_same_box(focus_box(turned), focus);
    }
}

TEST(Focus, SkipsWhatIsNotFinite) {
    Pieces pieces;
    pieces.add_sheet();
    pieces.frame.position(1, 0) = std::numeric_limits<double>::quiet_NaN();
    pieces.add(Vector3d(0, std::numeric_limits<double>::infinity(), 0), 0.1);
    expect_same_box(pieces.focus(), whole);
    pieces.frame.position.setConstant(std::numeric_limits<double>::quiet_NaN());
    EXPECT_TRUE(pieces.focus().isEmpty());
}

/// Test with a synthetic run in which the last column may be a fragment that flies away.
class Stage : public ::testing::Test {
  protected:
    Stage() : run(synthetic_run()) {
        // The fragment's faces are small, so that it is a small part of the sheet.
        for (double& area : run.header.rest_area) area = 1;
        const Index last_column = (synthetic::columns - 1) * synthetic::rows * 2;
        for (auto f = static_cast<std::size_t>(last_column); f < run.header.rest_faces.size(); ++f) {
            run.header.rest_area[f] = 0.01;
            Snapshot& frame = run.frames[2];
            frame.face_fragment[f] = 7;
            for (Index& v : frame.faces[f]) v = copy_of(v);
        }
        set_rest(run);
    }

    Index copy_of(Index vertex) {
        Snapshot& frame = run.frames[2];
        if (const auto found = copies.find(vertex); found != copies.end()) return found->second;
        const auto made = static_cast<Index>(frame.original.size());
        frame.original.push_back(frame.original[vertex]);
        frame.position.conservativeResize(3, made + 1);
        frame.position.col(made) = frame.position.col(vertex);
        frame.velocity.conservativeResize(3, made + 1);
        frame.velocity.col(made).setZero();
        frame.mass.conservativeResize(made + 1);
        frame.mass[made] = 1e-4;
        return copies[vertex] = made;
    }

    Camera camera_when_it_flies(const Vector3d& way, AlignedBox3d* everything = nullptr) {
        SyntheticRun flown = run;
        for (const auto& [vertex, copy] : copies) flown.frames[2].position.col(copy) += way;
        const std::filesystem::path file = folder.path / ("run" + std::to_string(++recorded) + ".h5");
        record(flown, file);
        std::vector<std::string> warnings;
        const RenderStage stage(Recording(file), {}, warnings);
        if (everything) *everything = stage.everything();
        Camera camera = stage.camera();
        camera.eye += stage.centre();
        camera.target += stage.centre();
        return camera;
    }

    TemporaryDirectory folder;
    SyntheticRun run;
    std::map<Index, Index> copies;  ///< copies of the splinter's vertices
    int recorded = 0;
};

TEST_F(Stage, HoldsTheCameraOnTheActionWhenASplinterFliesAway) {
    const Camera near = camera_when_it_flies(Vector3d(0, 0, 0));
    AlignedBox3d everything;
    const Camera far = camera_when_it_flies(Vector3d(0, 40, 10), &everything);
    EXPECT_LT((near.eye - far.eye).norm(), 0.05);
    EXPECT_LT((near.target - far.target).norm(), 0.05);
    EXPECT_GT(everything.max().y(), 40) << "the page keeps places of all that it shows";
}

}  // namespace
}  // namespace sherd::test
