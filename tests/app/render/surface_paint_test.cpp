// SPDX-License-Identifier: GPL-3.0-or-later
// Textures, materials and colours of sheets in pictures: if a test failed, a textured bowl would be drawn in
// white, or in wrong colours.
#include "app/render/surface_paint.h"

#include <gtest/gtest.h>
#include <jpeglib.h>

#include <cstdio>

#include "app/commands/render.h"
#include "app/files/picture/image.h"
#include "app/render/trace/render_light.h"
#include "meshops/error.h"
#include "tests/support/program/message_thrown_by.h"
#include "tests/support/program/png_file.h"
#include "tests/support/program/temporary_directory.h"
#include "tests/support/recording/synthetic_run.h"

namespace sherd::test {
namespace {

namespace fs = std::filesystem;

/// Writes a JPEG file of a single colour.
void write_jpeg(const fs::path& file, int width, int height, std::array<JSAMPLE, 3> colour) {
    jpeg_compress_struct jpeg{};
    jpeg_error_mgr errors{};
    jpeg.err = jpeg_std_error(&errors);
    jpeg_create_compress(&jpeg);
    std::FILE* stream = std::fopen(file.c_str(), "wb");
    jpeg_stdio_dest(&jpeg, stream);
    jpeg.image_width = static_cast<JDIMENSION>(width);
    jpeg.image_height = static_cast<JDIMENSION>(height);
    jpeg.input_components = 3;
    jpeg.in_color_space = JCS_RGB;
    jpeg_set_defaults(&jpeg);
    jpeg_start_compress(&jpeg, TRUE);
    std::vector<JSAMPLE> row;
    for (int i = 0; i < width; ++i) row.insert(row.end(), colour.begin(), colour.end());
    for (int y = 0; y < height; ++y) {
        JSAMPROW start = row.data();
        jpeg_write_scanlines(&jpeg, &start, 1);
    }
    jpeg_finish_compress(&jpeg);
    jpeg_destroy_compress(&jpeg);
    std::fclose(stream);
}

class Painted : public testing::Test {
  protected:
    Painted() : run(synthetic_run()) { write_jpeg(folder.path / "green.jpg", 9, 5, {20, 200, 30}); }

    /// Calls change(look, number of faces) for the look of each frame and of the header.
    template <class Change>
    void look(Change change) {
        for (Snapshot& frame : run.frames) change(frame.rest.look, frame.faces.size());
        change(run.header.rest_look, run.header.rest_faces.size());
    }
    void paint_green() {
        look([&](SurfaceLook& look, std::size_t faces) {
            const Eigen::Vector2d inside(0.3, 0.3);
            look.texture.assign(faces, {inside, inside, inside});
            look.material.assign(
                faces, std::make_shared<const SurfaceMaterial>(SurfaceMaterial{
                           "glaze", "Kd 1 0 0\nmap_Kd " + (folder.path / "green.jpg").string() + "\n"}));
        });
    }
    RenderOptions options() const {
        RenderOptions options;
        options.recording = folder.path / "run.h5";
        options.output = folder.path / "picture.png";
        options.size = "96x54";
        options.samples = 4;
        options.colour = "material";
        options.force = true;
        return options;
    }
    /// Numbers of pixels in which red, green or blue, in this order, far exceeds the other two.
    std::array<int, 3> pixels() const {
        const Image image = read_png(folder.path / "picture.png");
        std::array<int, 3> count{};
        for (const auto& pixel : image.colours.colwise())
            for (int k = 0; k < 3; ++k)
                count[k] += pixel[k] > pixel[(k + 1) % 3] + 0.2f && pixel[k] > pixel[(k + 2) % 3] + 0.2f;
        return count;
    }

    TemporaryDirectory folder;
    SyntheticRun run;
};

TEST_F(Painted, ThePictureOfTheMaterialIsSeen) {
    paint_green();
    record(run, folder.path / "run.h5");
    render_recording(options());
    EXPECT_GT(pixels()[1], 100);
    EXPECT_EQ(pixels()[0], 0);
}

TEST_F(Painted, WithoutThePictureTheColourStandsForItAndThisIsTold) {
    paint_green();
    std::vector<std::string> warnings;
    const SurfacePaint there(run.header.rest_look, warnings);
    EXPECT_TRUE(warnings.empty());
    fs::remove(folder.path / "green.jpg");
    const SurfacePaint gone(run.header.rest_look, warnings);
    ASSERT_EQ(warnings.size(), 1u);
    EXPECT_NE(warnings[0].find("green.jpg"), std::string::npos);
    record(run, folder.path / "run.h5");
    render_recording(options());
    EXPECT_GT(pixels()[0], 100);
}

TEST_F(Painted, ColoursOfPlyAreSeen) {
    look([](SurfaceLook& look, std::size_t faces) {
        look.face_colour.assign(faces, Colour{10, 20, 230, 255});
    });
    record(run, folder.path / "run.h5");
    render_recording(options());
    EXPECT_GT(pixels()[2], 100);
}

TEST_F(Painted, ARecordingOfWhichFilesSayNothingIsAnError) {
    record(run, folder.path / "run.h5");
    EXPECT_NE(message_thrown_by([&] { render_recording(options()); }).find("no materials and no colours"),
              std::string::npos);
}

TEST_F(Painted, AFaceShowsItsOwnPartOfThePicture) {
    paint_green();
    Snapshot& frame = run.frames.back();
    frame.rest.look.texture[1][1].x() = 0.75;
    std::vector<std::string> warnings;
    const SheetPaint paint =
        SurfacePaint(run.header.rest_look, warnings).paint(frame, Eigen::Vector3f::Ones());
    EXPECT_EQ(paint.picture, std::vector<std::int32_t>(frame.faces.size(), 0));
    const RenderMesh mesh =
        sheet_solid(frame, std::vector<double>(frame.faces.size(), 0.001), paint, Vector3d::Zero());
    ASSERT_EQ(mesh.picture.size(), mesh.triangles.size());
    EXPECT_EQ(mesh.vertices[mesh.triangles[2][1]].texture.x(), 0.75f) << "upper side of face 1";
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const bool is_broken = mesh.vertices[mesh.triangles[t][0]].broken > 0;
        EXPECT_EQ(mesh.picture[t], is_broken ? -1 : 0);
    }
}

// Pictures that a .mtl file names may be damaged, as other files may be.
TEST(Jpeg, IsReadAndFaultsAreTold) {
    const TemporaryDirectory folder;
    write_jpeg(folder.path / "a.jpg", 7, 3, {250, 128, 0});
    const Image image = read_picture(folder.path / "a.jpg");
    ASSERT_EQ(image.width, 7);
    ASSERT_EQ(image.height, 3);
    EXPECT_NEAR(image.colour(6, 2).x(), 250 / 255.0, 0.02);
    EXPECT_NEAR(image.colour(6, 2).y(), 128 / 255.0, 0.02);
    const std::string whole = folder.contents().at(folder.path / "a.jpg");
    folder.write("head.jpg", whole.substr(0, 30));
    EXPECT_NE(message_thrown_by([&] { read_picture(folder.path / "head.jpg"); }).find("head.jpg"),
              std::string::npos);
    EXPECT_NE(message_thrown_by([&] { read_picture(folder.path / "none.jpg"); }).find("none.jpg"),
              std::string::npos);
    folder.write("text.jpg", "no picture");
    EXPECT_NE(message_thrown_by([&] { read_picture(folder.path / "text.jpg"); }).find("text.jpg"),
              std::string::npos);
}

TEST(MaterialLook, IsWhatTheDefinitionSays) {
    const MaterialLook look =
        material_look({"glaze", "Kd 0.1 0.2 2\nd 0.25\nNs 225\nKe 0 1 0\nmap_Kd -s 2 2 2 /a b/c d.png\n"});
    EXPECT_EQ(look.colour, Eigen::Vector3f(0.1f, 0.2f, 1));
    EXPECT_EQ(look.opacity, 0.25f);
    EXPECT_FLOAT_EQ(look.roughness, 0.5f);
    EXPECT_EQ(look.glow, Eigen::Vector3f(0, 1, 0));
    EXPECT_EQ(look.picture, "/a b/c d.png");
    const MaterialLook odd = material_look({"odd", "Kd spectral file.rfl 1\nd\nTr 0.5\nNs nan\n"});
    EXPECT_EQ(odd.colour, MaterialLook().colour);
    EXPECT_EQ(odd.opacity, 0.5f);
    EXPECT_TRUE(odd.picture.empty());
}

}  // namespace
}  // namespace sherd::test
