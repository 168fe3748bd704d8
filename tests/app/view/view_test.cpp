// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/view.h"

#include <gtest/gtest.h>

#include "app/view/view_assets.h"
#include "app/view/view_data.h"
#include "meshops/error.h"
#include "tests/support/program/base64.h"
#include "tests/support/program/program.h"
#include "tests/support/program/temporary_directory.h"
#include "tests/support/recording/synthetic_run.h"

namespace sherd::test {
namespace {

using Frames = std::vector<std::size_t>;
using Json = nlohmann::json;

TEST(ViewFrames, AreThinnedToTheRoomThereIs) {
    EXPECT_EQ(shown_frames(4, 10, 1000), (Frames{0, 1, 2, 3}));
    EXPECT_EQ(shown_frames(11, 10, 60), (Frames{0, 2, 4, 6, 8, 10}));
    EXPECT_EQ(shown_frames(100, 1000000, 10), (Frames{0, 99})) << "the first and the last always";
    EXPECT_EQ(shown_frames(1, 1000000, 10), (Frames{0}));
}

/// Test with a recording of the synthetic run, and with the data of its page.
class View : public ::testing::Test {
  protected:
    View() : run(synthetic_run()) { record(run, folder.path / "run.h5"); }

    Json data(const Frames& frames, RenderColour colour = RenderColour::strain) {
        const Recording recording(folder.path / "run.h5");
        StageOptions options;
        options.colour = colour;
        const RenderStage stage(recording, options, warnings);
        return view_data(recording, stage, frames);
    }

    TemporaryDirectory folder;
    SyntheticRun run;
    std::vector<std::string> warnings;
};

// A page that lost a face's corner or its fragment would show another run.
TEST_F(View, BuildsEveryFrameFromTheChanges) {
    for (const Frames& frames : {Frames{0, 1, 2}, Frames{0, 2}}) {
        const Json page = data(frames);
        auto corners = decoded<std::uint32_t>(page["faces"]),
             owners = decoded<std::uint32_t>(page["fragments"]);
        for (std::size_t i = 0; i < frames.size(); ++i) {
            const Snapshot& frame = run.frames[frames[i]];
            const Json& packed = page["frames"][i];
            const auto moved = decoded<std::uint32_t>(packed["corners"]),
                       given = decoded<std::uint32_t>(packed["owners"]);
            EXPECT_EQ(moved.empty(), i == 0);
            for (std::size_t k = 0; k < moved.size(); k += 2) corners[moved[k]] = moved[k + 1];
            for (std::size_t k = 0; k < given.size(); k += 2) owners[given[k]] = given[k + 1];
            for (std::size_t f = 0; f < frame.faces.size(); ++f) {
                for (int k = 0; k < 3; ++k)
                    ASSERT_EQ(corners[3 * f + k], static_cast<std::uint32_t>(frame.faces[f][k]));
                ASSERT_EQ(owners[f], static_cast<std::uint32_t>(frame.face_fragment[f]));
            }
        }
    }
}

TEST_F(View, KeepsPositionsToAFewMillionthsOfTheSize) {
    const Json page = data({0, 1, 2});
    for (std::size_t i = 0; i < 3; ++i) {
        const auto packed = decoded<std::uint16_t>(page["frames"][i]["position"]);
        const Positions& position = run.frames[i].position;
        ASSERT_EQ(packed.size(), static_cast<std::size_t>(position.size()));
        Positions shift = Positions::Zero(3, position.cols());
        for (Eigen::Index v = 0; v < position.cols(); ++v)
            for (int k = 0; k < 3; ++k)
                shift(k, v) = page["low"][k].get<double>() +
                              packed[3 * v + k] * page["step"][k].get<double>() - position(k, v);
        // Positions in the page are relative to the centre of the action, so that all are shifted by one
        // vector.
        const Vector3d first = shift.col(0);
        for (int k = 0; k < 3; ++k)
            EXPECT_LE((shift.colwise() - first).row(k).cwiseAbs().maxCoeff(),
                      1.01 * page["step"][k].get<double>());
    }
}

// The brightest colour must stand for the largest value on the bar, and the darkest for compression.
TEST_F(View, ShowsStressInsteadOfStrain) {
    EXPECT_EQ(data({0})["scalar"], "strain");
    add_fields(run);
    for (Snapshot& frame : run.frames) {
        frame.fields.stress_top.colwise() = Vector3d(-3e6, -3e6, 0);
        frame.fields.stress_bottom = frame.fields.stress_top;
        for (std::size_t f = 0; f < frame.faces.size() / 2; ++f)
            frame.fields.stress_bottom.col(static_cast<Eigen::Index>(f)) << 1e6, 5e6, 0;
    }
    {
        RecordingWriter writer(folder.path / "run.h5", run.header, true);
        for (std::size_t k = 0; k < run.frames.size(); ++k)
            writer.append(run.frames[k], run.steps[k], run.events[k]);
    }
    const Json page = data({0, 2}, RenderColour::stress);
    EXPECT_EQ(page["scalar"], "stress");
    EXPECT_EQ(page["bar"]["title"], "stress (MPa)");
    const auto shown = decoded<std::uint8_t>(page["frames"][0]["scalar"]);
    EXPECT_EQ(shown[run.frames[0].faces.front()[0]], 255);
    EXPECT_EQ(shown[run.frames[0].faces.back()[0]], 0);

    ViewOptions options;
    options.recording = folder.path / "run.h5";
    options.colour = "speed";
    EXPECT_THROW(view_page(options, warnings), Error) << "a thinned mesh has none";
}

// Tips beside their cracks, or missing tips, would show a wrong propagation.
TEST_F(View, HasTheTipsOfEachFrame) {
    EXPECT_EQ(data({0, 1})["tips"], false);
    add_tips(run);
    std::filesystem::remove(folder.path / "run.h5");
    std::filesystem::remove(folder.path / "run.xdmf");
    record(run, folder.path / "run.h5");
    const Json page = data({0, 1, 2});
    EXPECT_EQ(page["tips"], true);
    std::vector<std::vector<float>> tips;
    for (const Json& frame : page["frames"]) tips.push_back(decoded<float>(frame["tips"]));
    EXPECT_TRUE(tips[0].empty());
    ASSERT_EQ(tips[1].size(), 2 * 13u);
    ASSERT_EQ(tips[2].size(), 13u);
    EXPECT_EQ(tips[2][0], 1) << "its number";
    EXPECT_EQ(tips[2][4], 1) << "along x";
    EXPECT_EQ(tips[2][7], 2000) << "m/s";
    EXPECT_EQ(tips[2][8], 1) << "G / G_c";
    EXPECT_EQ(tips[2][9], 2e7f) << "K_I";
    const Vector3d way =
        Vector3d(tips[2][1], tips[2][2], tips[2][3]) - Vector3d(tips[1][14], tips[1][15], tips[1][16]);
    EXPECT_LT((way - Vector3d(0.05, 0, -0.02)).norm(), 1e-7);
}

// Thickness and obstacles that do not fit the frames would be drawn wrongly, or not at all.
TEST_F(View, HasTheThicknessAndWhereObstaclesAre) {
    run.header.rest_thickness.assign(run.header.rest_faces.size(), 0.004);
    set_rest(run);
    const RecordedObstacle solid{"anvil",
                                 {{{0, 0, 0}, {1, 0, 0}, {0, 2, 0}, {0, 0, 3}}, {{0, 2, 1}, {0, 1, 3}}}};
    {
        RecordingWriter writer(folder.path / "run.h5", run.header, true, {{solid}});
        for (std::size_t k = 0; k < run.frames.size(); ++k) {
            const Eigen::Isometry3d pose(Eigen::Translation3d(0.1 * static_cast<double>(k), 0, 0));
            writer.append(run.frames[k], run.steps[k], run.events[k], {{pose}});
        }
    }
    const Json page = data({0, 2});
    EXPECT_EQ(decoded<float>(page["thickness"]), std::vector<float>(run.header.rest_faces.size(), 0.004f));
    ASSERT_EQ(page["obstacles"].size(), 1u);
    EXPECT_EQ(decoded<float>(page["obstacles"][0]["points"]),
              (std::vector<float>{0, 0, 0, 1, 0, 0, 0, 2, 0, 0, 0, 3}));
    EXPECT_EQ(decoded<std::uint32_t>(page["obstacles"][0]["faces"]),
              (std::vector<std::uint32_t>{0, 2, 1, 0, 1, 3}));
    const auto first = decoded<float>(page["frames"][0]["poses"]),
               last = decoded<float>(page["frames"][1]["poses"]);
    ASSERT_EQ(first.size(), 16u);
    EXPECT_NEAR(last[12] - first[12], 0.2, 1e-6) << "the last column is the place";
}

TEST_F(View, DrawsCracksAsCracksAndTheRimAsRim) {
    const Json page = data({0, 2});
    const auto count = [&](std::size_t frame, std::uint32_t state) {
        const auto lines = decoded<std::uint32_t>(page["frames"][frame]["lines"]);
        int found = 0;
        for (std::size_t i = 2; i < lines.size(); i += 3) found += lines[i] == state;
        return found;
    };
    const int rim = 2 * (synthetic::columns + synthetic::rows);
    EXPECT_EQ(count(0, 0), rim);
    EXPECT_EQ(count(0, 2), 0);
    EXPECT_EQ(count(1, 0), rim);
    EXPECT_EQ(count(1, 2), 16) << "two crack faces of eight edges";
}

// The page must contain its scripts unchanged, as the build embeds them in the program, and must not load
// anything from elsewhere.
TEST_F(View, PageIsWholeAndAsksForNothingElse) {
    ViewOptions options;
    options.recording = folder.path / "run.h5";
    const std::string page = view_page(options, warnings);
    EXPECT_NE(page.find(view_assets::three), std::string::npos);
    EXPECT_NE(page.find(view_assets::controls), std::string::npos);
    EXPECT_NE(page.find(view_assets::playback), std::string::npos);
    EXPECT_GT(view_assets::three.size(), 500'000u);
    EXPECT_TRUE(view_assets::page.ends_with("</html>\n"));
    EXPECT_TRUE(page.ends_with("</html>\n"));
    for (const char* word :
         {"%TITLE%", "%THREE%", "%CONTROLS%", "%PLAYBACK%", "%PAINT%", "%RECORDING%", " src=", "<link"})
        EXPECT_EQ(page.find(word), std::string::npos) << word;
    const std::size_t begin = page.find("{\"angle\""), end = page.find("</script>", begin);
    EXPECT_EQ(Json::parse(page.substr(begin, end - begin))["frames"].size(), 3u);
    EXPECT_LT(page.size() - (end - begin), 1'500'000u);
}

TEST_F(View, PlaysInSlowMotion) {
    ViewOptions options;
    options.recording = folder.path / "run.h5";
    EXPECT_NE(view_page(options, warnings).find("\"slow\":20.0,"), std::string::npos) << "0.2 s last 4 s";
    options.slow = 3;
    EXPECT_NE(view_page(options, warnings).find("\"slow\":3.0,"), std::string::npos);
    options.slow = -1;
    EXPECT_THROW(view_page(options, warnings), Error);
    const ProgramResult result = run_sherd({"view", "run.h5"}, folder.path);
    EXPECT_NE(result.err.find("20 times slower than reality: 0.2 s last 4 s"), std::string::npos)
        << result.err;
}

TEST_F(View, LeavesFramesOutWithAWarning) {
    {
        RecordingWriter writer(folder.path / "run.h5", run.header, true);
        for (int k = 0; k < 40; ++k) writer.append(run.frames[0], run.steps[0], run.events[0]);
    }
    ViewOptions options;
    options.recording = folder.path / "run.h5";
    options.megabytes = 0.025;
    view_page(options, warnings);
    EXPECT_NE(warnings.back().find(" of 40 frames"), std::string::npos) << warnings.back();
    EXPECT_EQ(warnings.back().find("merged"), std::string::npos) << warnings.back();
}

/// Square of `sides` x `sides` squares, torn in two along its middle in the second of two frames.
struct TornSquare {
    RecordingHeader header;
    std::vector<Snapshot> frames;
};

TornSquare torn_square(Index sides) {
    TornSquare square;
    const Index across = sides + 1, middle = sides / 2, count = across * across;
    square.header.sheet_names = {"square"};
    square.header.rest_position = Positions::Zero(3, count);
    for (Index v = 0; v < count; ++v) {
        const Index row = v / across, column = v % across;
        square.header.rest_position.col(v).head<2>() << 1.0 * row / sides, 1.0 * column / sides;
    }
    Snapshot whole;
    for (Index v = 0; v < count; ++v) whole.original.push_back(v);
    for (Index x = 0; x < sides; ++x)
        for (Index y = 0; y < sides; ++y) {
            const Index a = x * across + y, b = a + across;
            for (const auto& face : {std::array{a, b, b + 1}, std::array{a, b + 1, a + 1}})
                square.header.rest_faces.push_back(face);
        }
    square.header.rest_area.assign(square.header.rest_faces.size(), 0.5 / (sides * sides));
    square.header.rest_thickness.assign(square.header.rest_faces.size(), 0.001);
    whole.position = square.header.rest_position;
    whole.faces = square.header.rest_faces;
    whole.face_fragment.assign(whole.faces.size(), 0);
    whole.face_sheet.assign(whole.faces.size(), 0);
    whole.rest = recording_format::unfractured_mesh(square.header);
    Snapshot torn = whole;
    torn.position.conservativeResize(3, count + across);
    torn.position.rightCols(across) = whole.position.middleCols(middle * across, across);
    for (Index y = 0; y < across; ++y) torn.original.push_back(middle * across + y);
    for (std::size_t f = 0; f < torn.faces.size(); ++f) {
        if (static_cast<Index>(f) < 2 * sides * middle) continue;
        torn.face_fragment[f] = 1;
        for (Index& v : torn.faces[f])
            if (v / across == middle) v += count - middle * across;
    }
    // The right half has moved to the side.
    for (Eigen::Index v = (middle + 1) * across; v < torn.position.cols(); ++v) torn.position(0, v) += 1;
    square.frames = {whole, torn};
    return square;
}

// If thinning closed a crack or distorted a fragment, the page would show another run.
TEST(MeshThinning, KeepsFragmentsApartAndTheirShape) {
    const TornSquare square = torn_square(60);
    const MeshThinning thinning(square.header, square.frames[0].face_sheet, 0.1);
    const std::size_t faces = thinning.thinned(square.frames[0]).faces.size();
    for (const Snapshot& frame : square.frames) {
        const Snapshot coarse = thinning.thinned(frame);
        ASSERT_EQ(coarse.faces.size(), faces);
        EXPECT_EQ(coarse.rest.thickness.size(), faces);
        EXPECT_LE(coarse.position.cols(), 11 * 12);
        EXPECT_GE(coarse.position.cols(), 10 * 10);
        double area = 0;
        for (std::size_t f = 0; f < coarse.faces.size(); ++f) {
            const auto& [a, b, c] = coarse.faces[f];
            const Vector3d p = coarse.position.col(a), q = coarse.position.col(b), r = coarse.position.col(c);
            const double doubled = (q - p).cross(r - p).z();
            area += doubled / 2;
            if (frame.face_fragment.back() == 0) continue;
            for (const Vector3d& corner : {p, q, r})
                EXPECT_EQ(corner.x() > 1.2, coarse.face_fragment[f] == 1);
        }
        EXPECT_NEAR(area, 0.8, 0.15) << "half a cube is lost at the rim";
    }
}

// If fields came from other faces, colours would be at wrong places.
TEST(MeshThinning, KeepsTheFieldsOfFacesWhereTheyAre) {
    const TornSquare square = torn_square(40);
    Snapshot frame = square.frames[0];
    frame.fields.curvature = Eigen::Matrix3Xd::Zero(3, static_cast<Eigen::Index>(frame.faces.size()));
    const auto middle = [](const Snapshot& of, std::size_t face) -> Vector3d {
        return columns(of.position, of.faces[face]).rowwise().mean();
    };
    for (std::size_t f = 0; f < frame.faces.size(); ++f)
        frame.fields.curvature.col(static_cast<Eigen::Index>(f)) = middle(frame, f);
    const Snapshot coarse = MeshThinning(square.header, frame.face_sheet, 0.1).thinned(frame);
    ASSERT_EQ(coarse.fields.curvature.cols(), static_cast<Eigen::Index>(coarse.faces.size()));
    for (std::size_t f = 0; f < coarse.faces.size(); ++f)
        EXPECT_LT((coarse.fields.curvature.col(static_cast<Eigen::Index>(f)) - middle(coarse, f)).norm(),
                  0.1);
    EXPECT_EQ(coarse.fields.stress_top.size(), 0);
}

// A page that is too large must still open, with about the given size.
TEST_F(View, ThinsALargeMeshWithAWarning) {
    const TornSquare square = torn_square(250);
    {
        RecordingWriter writer(folder.path / "large.h5", square.header, true);
        for (const Snapshot& frame : square.frames) {
            Snapshot complete = frame;
            complete.velocity = Positions::Zero(3, frame.position.cols());
            complete.mass = VectorXd::Ones(frame.position.cols());
            writer.append(complete, {}, {});
        }
    }
    ViewOptions options;
    options.recording = folder.path / "large.h5";
    options.megabytes = 1;
    const std::string page = view_page(options, warnings);
    EXPECT_NE(warnings.back().find("of 63252 vertices"), std::string::npos) << warnings.back();
    const std::size_t begin = page.find("{\"angle\""), end = page.find("</script>", begin);
    EXPECT_LT(end - begin, 1'300'000u);
    EXPECT_GT(end - begin, 400'000u);
    const Json data = Json::parse(page.substr(begin, end - begin));
    EXPECT_EQ(data["frames"].size(), 2u) << "all frames";
    EXPECT_EQ(decoded<std::uint32_t>(data["faces"]).size(), 3 * decoded<float>(data["thickness"]).size());
}

TEST_F(View, WritesBesideTheRecordingAndKeepsWhatIsThere) {
    const ProgramResult first = run_sherd({"view", "run.h5"}, folder.path);
    EXPECT_EQ(first.exit_code, 0) << first.err;
    EXPECT_EQ(first.out, "run.html\n");
    const auto before = folder.contents();
    const ProgramResult second = run_sherd({"view", "run.h5"}, folder.path);
    EXPECT_EQ(second.exit_code, 2);
    EXPECT_NE(second.err.find("--force"), std::string::npos) << second.err;
    EXPECT_EQ(folder.contents(), before);
    EXPECT_EQ(run_sherd({"view", "run.h5", "--force"}, folder.path).exit_code, 0);
    EXPECT_EQ(folder.contents(), before) << "the same bytes again";
}

}  // namespace
}  // namespace sherd::test
