// SPDX-License-Identifier: GPL-3.0-or-later
// Colour bar and caption of pictures.
#include <gtest/gtest.h>

#include <cmath>

#include "app/commands/render.h"
#include "app/render/legend/colour_bar.h"
#include "app/render/legend/render_colour.h"
#include "app/render/legend/text.h"
#include "app/render/render_stage.h"
#include "tests/support/program/program.h"
#include "tests/support/program/temporary_directory.h"
#include "tests/support/recording/synthetic_run.h"

namespace sherd::test {
namespace {

using Eigen::Vector3f;

Image blank(int width, int height, float grey) {
    return {width, height, Eigen::Matrix3Xf::Constant(3, static_cast<Eigen::Index>(width) * height, grey)};
}

bool inside(const PixelBox& box, int column, int row) {
    return column >= box.left && column < box.right && row >= box.top && row < box.bottom;
}

std::vector<std::string> words_of(const ColourBar& bar) {
    std::vector<std::string> words;
    for (const BarTick& tick : bar.ticks) words.push_back(tick.words);
    return words;
}

TEST(ColourBar, HasRoundTicksAndTheRangeOfItsColours) {
    const ColourBar speed = make_colour_bar("speed", "m/s", {0, 0.0374}, {0, 0.112});
    EXPECT_EQ(speed.title, "speed (mm/s)");
    EXPECT_EQ(make_colour_bar("G / G_c", "", {0, 2}, {0, 1}).title, "G / G_c");
    EXPECT_EQ(words_of(speed), (std::vector<std::string>{"0", "10", "20", "30", "\xe2\x89\xa5 37.4"}));
    EXPECT_NEAR(speed.ticks[2].share, 20 / 37.4, 1e-12);
    EXPECT_TRUE(speed.above);
    EXPECT_FALSE(speed.below);
    const ColourBar strain = make_colour_bar("strain", "1/m", {10, 250}, {2, 250});
    EXPECT_EQ(strain.title, "strain (1/m)");
    EXPECT_EQ(words_of(strain),
              (std::vector<std::string>{"\xe2\x89\xa4 10", "50", "100", "150", "200", "250"}));
    EXPECT_TRUE(strain.below);
    EXPECT_FALSE(strain.above);
    EXPECT_EQ(make_colour_bar("speed", "m/s", {0, 61.23456}, {0, 9}).ticks.back().words, "61.23");
}

// Overlapping labels could not be read.
TEST(ColourBar, KeepsTicksApart) {
    for (double high = 0.001; high < 1e5; high *= 1.37)
        for (const double low : {0.0, 0.3 * high, -high}) {
            const ColourBar bar = make_colour_bar("speed", "m/s", {low, high}, {low, high});
            ASSERT_GE(bar.ticks.size(), 3u) << low << " to " << high;
            EXPECT_EQ(bar.ticks.front().share, 0);
            EXPECT_EQ(bar.ticks.back().share, 1);
            for (std::size_t i = 1; i < bar.ticks.size(); ++i)
                EXPECT_GT(bar.ticks[i].share, bar.ticks[i - 1].share + 0.1) << low << " to " << high;
        }
}

// If captions of a run differed in form, numbers would move about in a film, and could not be read.
TEST(ColourBar, CaptionsOfARunHaveTheSameForm) {
    EXPECT_EQ(time_caption(0.0125, 125, 0.03), "t = 12.50 ms, step 125");
    EXPECT_EQ(time_caption(0, 0, 0.03), "t = 0.00 ms, step 0");
    EXPECT_EQ(time_caption(0.25, 2500, 2), "t = 0.250 s, step 2500");
    EXPECT_EQ(time_caption(0.25, 2500, 0.5), "t = 250.0 ms, step 2500");
    EXPECT_EQ(time_caption(0, 0, 0), "t = 0.000 s, step 0");
    EXPECT_EQ(time_caption(0.25, 5, 1, "load"), "load 0.250, step 5");
}

// Bar and caption must be legible in small and large pictures, on black and on white, and change no other
// pixels.
TEST(ColourBar, IsLegibleInPicturesOfAnySizeAndTouchesOnlyItsPanel) {
    const ColourBar bar = make_colour_bar("strain", "1/m", {10, 250}, {2, 300});
    const std::array<int, 2> sizes[] = {{220, 220}, {480, 270}, {960, 540}, {540, 960}, {3840, 2160}};
    for (const auto& [width, height] : sizes)
        for (const float grey : {0.0f, 1.0f}) {
            ASSERT_TRUE(fits_colour_bar(width, height));
            Image image = blank(width, height, grey);
            const PixelBox panel = draw_colour_bar(image, bar),
                           line = draw_caption(image, "t = 12.50 ms, step 125");
            ASSERT_TRUE(inside({0, 0, width, height}, panel.left, panel.top));
            ASSERT_TRUE(inside({0, 0, width, height}, panel.right, panel.bottom));
            ASSERT_TRUE(inside({0, 0, width, height}, line.left, line.top));
            ASSERT_TRUE(inside({0, 0, width, height}, line.right, line.bottom));
            EXPECT_TRUE(line.right < panel.left || line.top > panel.bottom);
            EXPECT_GT(line.bottom - line.top, std::max(19.0, 0.04 * std::min(width, height))) << width;
            int dark = 0, light = 0;
            for (int row = 0; row < height; ++row)
                for (int column = 0; column < width; ++column) {
                    const Vector3f colour = image.colour(column, row);
                    if (!inside(panel, column, row) && !inside(line, column, row))
                        ASSERT_EQ(colour, Vector3f::Constant(grey));
                    else if (inside(line, column, row)) {
                        dark += colour.maxCoeff() < 0.25f;
                        light += colour.minCoeff() > 0.75f;
                    }
                }
            EXPECT_GT(dark, 40) << width;
            EXPECT_GT(light, dark) << width;
        }
    EXPECT_FALSE(fits_colour_bar(219, 1000));
}

// A colour of the picture must be on the bar, beside the number for which it stands.
TEST(ColourBar, ShowsTheMapFromBelowUpwards) {
    Image image = blank(960, 540, 1);
    const ColourBar bar = make_colour_bar("strain", "1/m", {0, 250}, {0, 250});
    const PixelBox panel = draw_colour_bar(image, bar);
    const auto colour_of = [](double share) -> Vector3f {
        const std::uint32_t rgb = map_colour(share);
        return Eigen::Vector3i(rgb >> 16 & 255, rgb >> 8 & 255, rgb & 255).cast<float>() / 255;
    };
    // Pixels of the map in the column through the centre of the bar, from the top.
    const int column = panel.left + 10 + 7;
    std::vector<Vector3f> colours;
    for (int row = panel.top + 30; row < panel.bottom; ++row) {
        const Vector3f colour = image.colour(column, row);
        if (colour.maxCoeff() - colour.minCoeff() > 0.05f) colours.push_back(colour);
    }
    ASSERT_GT(colours.size(), 200u);
    for (std::size_t i = 0; i < colours.size(); ++i) {
        const double share = 1 - (static_cast<double>(i) + 0.5) / static_cast<double>(colours.size());
        ASSERT_LT((colours[i] - colour_of(share)).cwiseAbs().maxCoeff(), 0.02f) << share;
    }
}

// A letter that is missing in the font would be replaced by a box, and a unit would be illegible.
TEST(Text, HasTheLettersOfUnitsAndTheirWidths) {
    const Text text(20);
    Image missing = blank(60, 40, 1);
    text.write(missing, 10, 30, "\xef\xbf\xbf", Vector3f::Zero());
    for (const std::string letter : {"\xc2\xb5", "\xe2\x89\xa5", "\xe2\x89\xa4", "|", "7"}) {
        Image image = blank(60, 40, 1);
        text.write(image, 10, 30, letter, Vector3f::Zero());
        EXPECT_LT(image.colours.minCoeff(), 0.3f) << letter;
        EXPECT_GT((image.colours - missing.colours).cwiseAbs().maxCoeff(), 0.3f) << letter;
    }
    EXPECT_NEAR(text.width("0000"), 4 * text.width("7"), 1e-9) << "figures are of one width";
    EXPECT_NEAR(Text(40).width("strain"), 2 * text.width("strain"), 0.1);
    Image outside = blank(10, 10, 1);
    text.write(outside, -8, 14, "cut off on all sides", Vector3f::Zero());
}

/// Test that draws a recording of the synthetic run.
class RenderBar : public ::testing::Test {
  protected:
    RenderBar() { record(synthetic_run(), folder.path / "run.h5"); }

    Image drawn(const std::string& colour, bool plain) {
        RenderOptions options;
        options.recording = folder.path / "run.h5";
        options.output = folder.path / "picture.png";
        options.size = "480x270";
        options.samples = 1;
        options.colour = colour;
        options.plain = plain;
        options.force = true;
        render_recording(options);
        return read_png(options.output);
    }

    TemporaryDirectory folder;
};

// Beside bar and caption, a picture must be the same as without them.
TEST_F(RenderBar, DiffersFromThePlainPictureOnlyInBarAndCaption) {
    for (const std::string colour : {"speed", "strain"}) {
        const Image plain = drawn(colour, true), full = drawn(colour, false);
        Image again = plain;
        const Recording recording(folder.path / "run.h5");
        StageOptions options;
        options.colour = parse_render_colour(colour, render_colours);
        std::vector<std::string> warnings;
        const RenderStage stage(recording, options, warnings);
        const PixelBox panel = draw_colour_bar(again, *stage.colour_bar()),
                       line = draw_caption(again, stage.caption(recording.frame(2)));
        EXPECT_LT((again.colours - full.colours).cwiseAbs().maxCoeff(), 0.005f);
        int changed = 0;
        for (int row = 0; row < plain.height; ++row)
            for (int column = 0; column < plain.width; ++column) {
                const bool same = plain.colour(column, row) == full.colour(column, row);
                changed += !same;
                ASSERT_TRUE(same || inside(panel, column, row) || inside(line, column, row))
                    << column << " " << row;
            }
        EXPECT_GT(changed, 2000);
    }
}

TEST_F(RenderBar, IsOnlyWhereColoursMeanNumbers) {
    for (const std::string colour : {"fragment", "none"})
        EXPECT_EQ(drawn(colour, false).colours, drawn(colour, true).colours) << colour;
}

TEST_F(RenderBar, SaysThatAPictureIsTooSmallForIt) {
    const auto said = [&](const std::vector<std::string>& more) {
        std::vector<std::string> words{"render", "run.h5", "-o", "small.png", "--size", "160x90", "--force"};
        words.insert(words.end(), more.begin(), more.end());
        const ProgramResult result = run_sherd(words, folder.path);
        EXPECT_EQ(result.exit_code, 0);
        return result.err.find("--size 160x90: the pictures are too small for a colour bar") !=
               std::string::npos;
    };
    EXPECT_TRUE(said({"--color", "speed"}));
    EXPECT_FALSE(said({"--color", "speed", "--plain"}));
    EXPECT_FALSE(said({}));
}

}  // namespace
}  // namespace sherd::test
