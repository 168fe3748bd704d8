// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/view/view.h"

#include <gtest/gtest.h>

#include <cstring>

#include "app/view/view_assets.h"
#include "app/view/view_data.h"
#include "meshops/error.h"
#include "tests/support/program.h"
#include "tests/support/synthetic_run.h"
#include "tests/support/temporary_directory.h"

namespace sherd::test {
namespace {

using Frames = std::vector<std::size_t>;
using Json = nlohmann::json;

std::string coded(const std::string& text) {
    return base64({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
}

/// RFC 4648, section 10.
TEST(Base64, GivesTheTestVectors) {
    EXPECT_EQ(coded(""), "");
    EXPECT_EQ(coded("f"), "Zg==");
    EXPECT_EQ(coded("fo"), "Zm8=");
    EXPECT_EQ(coded("foo"), "Zm9v");
    EXPECT_EQ(coded("foobar"), "Zm9vYmFy");
    EXPECT_EQ(coded("\xff\xfe\xfb"), "//77");
}

template <class Number>
std::vector<Number> decoded(const std::string& text) {
    const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string bytes;
    std::uint32_t bits = 0;
    int count = 0;
    for (const char c : text) {
        if (c == '=') break;
        bits = bits << 6 | static_cast<std::uint32_t>(digits.find(c));
        count += 6;
        if (count < 8) continue;
        count -= 8;
        bytes += static_cast<char>(bits >> count & 255);
    }
    std::vector<Number> numbers(bytes.size() / sizeof(Number));
    std::memcpy(numbers.data(), bytes.data(), numbers.size() * sizeof(Number));
    return numbers;
}

TEST(ViewFrames, AreThinnedToTheRoomThereIs) {
    EXPECT_EQ(shown_frames(4, 10, 1000), (Frames{0, 1, 2, 3}));
    EXPECT_EQ(shown_frames(11, 10, 60), (Frames{0, 2, 4, 6, 8, 10}));
    EXPECT_EQ(shown_frames(100, 1000000, 10), (Frames{0, 99})) << "the first and the last always";
    EXPECT_EQ(shown_frames(1, 1000000, 10), (Frames{0}));
}

/// The synthetic run as a page has it.
class View : public ::testing::Test {
  protected:
    View() : run(synthetic_run()) { record(run, folder.path / "run.h5"); }

    Json data(const Frames& frames) {
        const Recording recording(folder.path / "run.h5");
        StageOptions options;
        options.colour = RenderColour::strain;
        const RenderStage stage(recording, options, warnings);
        return view_data(recording, stage, frames);
    }

    TemporaryDirectory folder;
    SyntheticRun run;
    std::vector<std::string> warnings;
};

// A page that lost a face's corner or its fragment on the way would show another run.
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
        // Seen from the middle of the action: the same shift for all.
        const Vector3d first = shift.col(0);
        for (int k = 0; k < 3; ++k)
            EXPECT_LE((shift.colwise() - first).row(k).cwiseAbs().maxCoeff(),
                      1.01 * page["step"][k].get<double>());
    }
}

// Thickness and obstacles that do not fit the frames would be drawn wrong, or not at all.
TEST_F(View, HasTheThicknessAndWhereObstaclesAre) {
    run.header.rest_thickness.assign(run.header.rest_faces.size(), 0.004);
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
    EXPECT_EQ(count(1, 2), 16) << "two lips of eight edges";
}

// What the build puts into the program must be the files as they are, and the page must stand alone.
TEST_F(View, PageIsWholeAndAsksForNothingElse) {
    ViewOptions options;
    options.recording = folder.path / "run.h5";
    const std::string page = view_page(options, warnings);
    EXPECT_NE(page.find(view_assets::three), std::string::npos);
    EXPECT_NE(page.find(view_assets::controls), std::string::npos);
    EXPECT_GT(view_assets::three.size(), 500'000u);
    EXPECT_TRUE(view_assets::page.ends_with("</html>\n"));
    EXPECT_TRUE(page.ends_with("</html>\n"));
    for (const char* word : {"%TITLE%", "%THREE%", "%CONTROLS%", "%RECORDING%", " src=", "<link"})
        EXPECT_EQ(page.find(word), std::string::npos) << word;
    const std::size_t begin = page.find("{\"angle\""), end = page.find("</script>", begin);
    EXPECT_EQ(Json::parse(page.substr(begin, end - begin))["frames"].size(), 3u);
    EXPECT_LT(page.size() - (end - begin), 1'500'000u);
}

TEST_F(View, LeavesFramesOutWithAWarning) {
    ViewOptions options;
    options.recording = folder.path / "run.h5";
    options.megabytes = 1e-3;
    view_page(options, warnings);
    EXPECT_NE(warnings.back().find("2 of 3 frames"), std::string::npos) << warnings.back();
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
