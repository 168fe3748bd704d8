// SPDX-License-Identifier: GPL-3.0-or-later
// If a test failed, the page of a textured bowl would show wrong pictures, materials or colours.
#include "app/view/page_look.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>

#include "app/commands/view.h"
#include "app/view/view_data.h"
#include "meshops/error.h"
#include "tests/support/program/base64.h"
#include "tests/support/program/message_thrown_by.h"
#include "tests/support/program/png_file.h"
#include "tests/support/program/temporary_directory.h"
#include "tests/support/recording/synthetic_run.h"

namespace sherd::test {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;
using Numbers = std::vector<std::uint32_t>;

/// Test with a synthetic run, whose sheets have different textures, materials and colours in each frame.
class LookOfPage : public ::testing::Test {
  protected:
    LookOfPage() : run(synthetic_run()) {
        write_png(folder.path / "blue.png", 4, 4, Colour16{0, 0, 65535});
        for (std::size_t k = 0; k < run.frames.size(); ++k) {
            const auto& frame = run.frames[k];
            run.frames[k].rest.look =
                look(frame.faces.size(), static_cast<std::size_t>(frame.rest.position.cols()), k);
        }
        run.header.rest_look = run.frames[0].rest.look;
        record(run, folder.path / "run.h5");
    }

    SurfaceLook look(std::size_t faces, std::size_t vertices, std::size_t k) const {
        SurfaceLook look;
        const Eigen::Vector2d quarter(0.25, 0.25);
        look.texture.assign(faces, {quarter, quarter, quarter});
        look.texture[k][0].y() = 7;
        const auto glaze = std::make_shared<const SurfaceMaterial>(
            SurfaceMaterial{"glaze", "Kd 1 0 0\nmap_Kd " + (folder.path / "blue.png").string() + "\n"});
        const auto clay = std::make_shared<const SurfaceMaterial>(SurfaceMaterial{"clay", "Kd 0.5 0.25 0\n"});
        look.material.assign(faces, glaze);
        look.material[k + 3] = clay;
        look.material[1] = nullptr;
        look.vertex_colour.assign(vertices, white);
        look.vertex_colour[k] = {1, 2, 3, 4};
        return look;
    }
    std::string page(const std::string& colour, double megabytes = 64) {
        ViewOptions options;
        options.recording = folder.path / "run.h5";
        options.colour = colour;
        options.megabytes = megabytes;
        return view_page(options, warnings);
    }

    bool is_reported(const std::string& words) const {
        return std::ranges::any_of(
            warnings, [&](const std::string& warning) { return warning.find(words) != std::string::npos; });
    }

    TemporaryDirectory folder;
    SyntheticRun run;
    std::vector<std::string> warnings;
};

void change(Numbers& numbers, const Json& pairs) {
    const auto changes = decoded<std::uint32_t>(pairs);
    for (std::size_t i = 0; i < changes.size(); i += 2) {
        numbers.resize(std::max<std::size_t>(numbers.size(), changes[i] + 1));
        numbers[changes[i]] = changes[i + 1];
    }
}

TEST_F(LookOfPage, IsThatOfEachFrame) {
    const Recording recording(folder.path / "run.h5");
    const RenderStage stage(recording, StageOptions(), warnings);
    SurfaceLook start = run.header.rest_look;
    start.material[0] = start.material[3];  // so that rows have another order than in the frames
    const PageLook look(start, 1'000'000, warnings);
    const Json data = view_data(recording, stage, {0, 1, 2}, {}, look);
    const auto first = [&](const char* name) { return decoded<std::uint32_t>(data["look"][name]); };
    Numbers texture = first("texture"), material = first("material"), colour = first("colour");
    for (std::size_t k = 0; k < 3; ++k) {
        const Snapshot& frame = run.frames[k];
        change(texture, data["frames"][k]["texture"]);
        change(material, data["frames"][k]["material"]);
        change(colour, data["frames"][k]["colour"]);
        ASSERT_EQ(material.size(), frame.faces.size());
        for (std::size_t f = 0; f < frame.faces.size(); ++f) {
            EXPECT_EQ(material[f], f == 1 ? 2u : f == k + 3 ? 0u : 1u) << "face " << f << " of frame " << k;
            for (std::size_t i = 0; i < 6; ++i)
                EXPECT_EQ(std::bit_cast<float>(texture[6 * f + i]), f == k && i == 1 ? 7 : 0.25f);
            for (std::size_t i = 0; i < 3; ++i)
                EXPECT_EQ(colour[3 * f + i],
                          frame.original[frame.faces[f][i]] == static_cast<Index>(k) ? 0x030201u : 0xffffffu);
        }
    }
    EXPECT_EQ(data["look"]["materials"], Json::parse("[[12355840, -1], [16711680, 0], [16777215, -1]]"))
        << "linear (0.5, 0.25, 0), red with a picture, and white that colours multiply";
}

TEST_F(LookOfPage, HasThePicturesAsTheyAre) {
    PagePictures pictures;
    EXPECT_EQ(pictures.add(folder.path / "blue.png"), 0);
    EXPECT_EQ(pictures.add(folder.path / "blue.png"), 0) << "each once";
    pictures.fit(pictures.bytes(), warnings);
    const std::string url = pictures.urls().at(0), head = "data:image/png;base64,";
    ASSERT_TRUE(url.starts_with(head));
    EXPECT_EQ(from_base64(url.substr(head.size())), folder.contents().at(folder.path / "blue.png"));
    EXPECT_TRUE(warnings.empty());
    EXPECT_NE(message_thrown_by([&] { pictures.add(folder.path / "none.png"); }).find("none.png"),
              std::string::npos);
}

TEST_F(LookOfPage, ALargePictureIsMadeSmallerAndThisIsTold) {
    std::vector<Colour16> noise(64 * 48);
    std::uint32_t random = 1;
    for (Colour16& colour : noise)
        for (std::uint16_t& channel : colour)
            channel = static_cast<std::uint16_t>((random = random * 1664525 + 1013904223) >> 16);
    write_png(folder.path / "noise.png", 64, 48, noise);
    PagePictures pictures;
    pictures.add(folder.path / "noise.png");
    pictures.add(folder.path / "blue.png");
    pictures.fit(4000, warnings);
    EXPECT_LE(pictures.bytes(), 4000u);
    ASSERT_EQ(warnings.size(), 1u) << "the small one stays";
    EXPECT_NE(warnings[0].find("noise.png' with 32 x 24 pixels"), std::string::npos) << warnings[0];
    EXPECT_EQ(pictures.urls().size(), 2u);
}

TEST_F(LookOfPage, WithoutAPictureTheColourStandsForItAndThisIsTold) {
    fs::remove(folder.path / "blue.png");
    const PageLook look(run.header.rest_look, 1'000'000, warnings);
    EXPECT_EQ(look.materials()[0].picture, -1);
    ASSERT_EQ(warnings.size(), 1u);
    EXPECT_NE(warnings[0].find("blue.png"), std::string::npos);
}

TEST_F(LookOfPage, IsShownAtFirstUnlessAnotherColourIsAskedFor) {
    EXPECT_NE(page("").find(R"("start":"material")"), std::string::npos);
    EXPECT_NE(page("material").find(R"("start":"material")"), std::string::npos);
    EXPECT_NE(page("strain").find(R"("start":"fragment")"), std::string::npos);
    EXPECT_FALSE(is_reported("no materials and colours"));
    const std::string small = page("", 0.012);
    EXPECT_NE(small.find(R"("start":"fragment")"), std::string::npos);
    EXPECT_EQ(small.find(R"("look":{)"), std::string::npos);
    EXPECT_TRUE(is_reported("no materials and colours"));
}

TEST_F(LookOfPage, CannotBeAskedForWhereThereIsNone) {
    for (Snapshot& frame : run.frames) frame.rest.look = {};
    run.header.rest_look = {};
    fs::remove(folder.path / "run.h5");
    fs::remove(folder.path / "run.xdmf");
    record(run, folder.path / "run.h5");
    EXPECT_NE(message_thrown_by([&] { page("material"); }).find("no materials and no colours"),
              std::string::npos);
    EXPECT_NE(page("").find(R"("start":"fragment")"), std::string::npos);
}

TEST(HalfSize, HasTheMeansOfFourPixels) {
    Image image{3, 2, Eigen::Matrix3Xf::Zero(3, 6)};
    image.colours.row(0) << 0, 0.4f, 1, 0.2f, 0.6f, 1;
    const Image half = half_size(image);
    ASSERT_EQ(half.width, 1);
    ASSERT_EQ(half.height, 1);
    EXPECT_FLOAT_EQ(half.colour(0, 0).x(), 0.3f);
    EXPECT_EQ(half_size(half).colour(0, 0), half.colour(0, 0));
}

TEST(PictureFile, OfAJpegIsReadBack) {
    const TemporaryDirectory folder;
    Image image{16, 8, Eigen::Matrix3Xf::Zero(3, 128)};
    image.colours.row(1).setConstant(0.75f);
    folder.write("green.jpg", picture_file(image, true).bytes);
    const PictureFile file = read_picture_file(folder.path / "green.jpg");
    EXPECT_STREQ(file.media_type(), "image/jpeg");
    const Image read = read_picture(folder.path / "green.jpg");
    ASSERT_EQ(read.width, 16);
    EXPECT_LT((read.colours - image.colours).cwiseAbs().maxCoeff(), 0.03f);
    folder.write("text.png", "no picture");
    EXPECT_NE(message_thrown_by([&] { read_picture_file(folder.path / "text.png"); }).find("neither"),
              std::string::npos);
}

}  // namespace
}  // namespace sherd::test
