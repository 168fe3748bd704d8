// SPDX-License-Identifier: GPL-3.0-or-later
// Parts of the renderer: cameras, bodies of sheets, colours, light.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <map>
#include <numbers>
#include <set>

#include "app/files/picture/image.h"
#include "app/render/legend/render_colour.h"
#include "app/render/render_solid.h"
#include "app/render/render_stripes.h"
#include "app/render/trace/camera.h"
#include "app/render/trace/render_picture.h"
#include "meshops/error.h"
#include "tests/support/program/message_thrown_by.h"
#include "tests/support/program/temporary_directory.h"
#include "tests/support/recording/synthetic_run.h"

namespace sherd::test {
namespace {

using Eigen::AlignedBox3d;

/// Place of a point in the picture; both coordinates are between -1 and 1 if it is inside.
Vector2d place_in_picture(const Camera& camera, double aspect, const Vector3d& point) {
    const CameraAxes axes = camera_axes(camera);
    const Vector3d to = point - camera.eye;
    const double slope = std::tan(camera.view_angle * M_PI / 360), depth = to.dot(axes.forward);
    return {to.dot(axes.right) / (depth * slope * aspect), to.dot(axes.top) / (depth * slope)};
}

// From any side, and in wide and tall pictures, the camera must neither cut the action off nor show it as a
// dot.
TEST(Camera, HasTheWholeActionInThePictureAndFillsIt) {
    const AlignedBox3d boxes[] = {{Vector3d(1, 2, 3), Vector3d(1.5, 2.1, 3.01)},
                                  {Vector3d(1.2, 1.9, 2), Vector3d(1.3, 2.5, 2.2)}};
    for (const Vector3d& up : {Vector3d(0, 0, 1), Vector3d(0, 1, 0), Vector3d(1, 0, 0), Vector3d(0, 0, -1)})
        for (double azimuth = -180; azimuth < 180; azimuth += 35)
            for (const double elevation : {-90, -20, 0, 28, 90})
                for (const double aspect : {0.5, 1.78}) {
                    const CameraChoice choice{.azimuth = azimuth, .elevation = elevation};
                    const Camera camera = place_camera(choice, boxes, up, aspect);
                    double most = 0;
                    for (const AlignedBox3d& box : boxes)
                        for (int i = 0; i < 8; ++i) {
                            const Vector3d corner = box.corner(static_cast<AlignedBox3d::CornerType>(i));
                            ASSERT_GT((corner - camera.eye).dot(camera_axes(camera).forward), 0);
                            most = std::max(most,
                                            place_in_picture(camera, aspect, corner).cwiseAbs().maxCoeff());
                        }
                    EXPECT_LT(most, 1);
                    EXPECT_GT(most, 0.85);
                }
}

TEST(Camera, LooksFromTheFrontAndFromTheRight) {
    const AlignedBox3d box(Vector3d(-1, -1, -1), Vector3d(1, 1, 1));
    const auto eye = [&](double azimuth) {
        return place_camera({.azimuth = azimuth, .elevation = 0}, {&box, 1}, Vector3d::UnitZ(), 1)
            .eye.normalized();
    };
    EXPECT_NEAR((eye(0) + Vector3d::UnitY()).norm(), 0, 1e-12);
    EXPECT_NEAR((eye(90) - Vector3d::UnitX()).norm(), 0, 1e-12);
    const CameraChoice placed = parse_camera("1,2,3,4,5,6,40");
    EXPECT_EQ(*placed.eye, Vector3d(1, 2, 3));
    EXPECT_EQ(*placed.target, Vector3d(4, 5, 6));
    EXPECT_EQ(placed.view_angle, 40);
    EXPECT_EQ(parse_camera("-30,10,1.5").zoom, 1.5);
    for (const char* text : {"0,0,1e30", "0,0,1e-30", "1e25,0,0,0,0,0", "0,0,nan"})
        EXPECT_THROW(parse_camera(text), Error) << text;
}

/// Test with the synthetic run, and a function that makes a body from a frame, 2 mm thick if not given
/// otherwise.
class Solid : public ::testing::Test {
  protected:
    static RenderMesh solid(const Snapshot& frame, const std::vector<double>& thickness) {
        SheetPaint paint;
        paint.colour.assign(frame.position.cols(), Eigen::Vector3f::Ones());
        return sheet_solid(frame, thickness, paint, Vector3d::Zero());
    }
    static RenderMesh solid(const Snapshot& frame) {
        return solid(frame, std::vector<double>(frame.faces.size(), 0.002));
    }

    SyntheticRun run = synthetic_run();
};

// A hole would let light into the sheets: each side of a triangle must belong to two triangles, at walls,
// too.
TEST_F(Solid, IsClosedInEveryFrame) {
    for (const Snapshot& frame : run.frames) {
        const RenderMesh mesh = solid(frame);
        using Place = std::array<float, 3>;
        std::map<std::pair<Place, Place>, int> sides;
        const auto place = [&](std::uint32_t v) {
            const Eigen::Vector3f& p = mesh.vertices[v].position;
            return Place{p.x(), p.y(), p.z()};
        };
        for (const auto& triangle : mesh.triangles)
            for (int k = 0; k < 3; ++k) {
                ++sides[{place(triangle[k]), place(triangle[(k + 1) % 3])}];
                --sides[{place(triangle[(k + 1) % 3]), place(triangle[k])}];
            }
        for (const auto& [side, balance] : sides) ASSERT_EQ(balance, 0);
    }
}

TEST_F(Solid, HasTheThicknessAndBrokenWallsWhereItCracked) {
    const Snapshot& frame = run.frames[2];
    const RenderMesh mesh = solid(frame);
    const std::size_t count = frame.original.size();
    for (std::size_t v = 0; v < count; ++v)
        EXPECT_NEAR((mesh.vertices[v].position - mesh.vertices[count + v].position).norm(), 0.002, 4e-5)
            << "of a surface that is a little bent"
            << "of a surface that is a little bent";
    std::size_t broken = 0, walls = 0, openings = 0;
    for (std::size_t v = 2 * count; v < mesh.vertices.size(); v += 4) {
        ++walls;
        broken += mesh.vertices[v].broken > 0;
    }
    for (const CrackEvents& events : run.events) openings += events.openings.size();
    EXPECT_EQ(openings, 8u);
    EXPECT_EQ(broken, 2 * openings) << "two lips of each";
    EXPECT_EQ(walls - broken, 2u * (synthetic::columns + synthetic::rows)) << "the rim as it was made";
}

// A body must be as thick at a vertex as the faces there on average: otherwise its surface would have steps,
// or depend on the order of the faces.
TEST_F(Solid, IsAsThickAtAVertexAsTheFacesThereOnTheMean) {
    const Snapshot& frame = run.frames[0];
    std::vector<double> thickness;
    for (std::size_t f = 0; f < frame.faces.size(); ++f) thickness.push_back(1e-3 * (1 + f % 3));
    const RenderMesh mesh = solid(frame, thickness);
    const std::size_t count = frame.original.size();
    std::vector<double> sum(count, 0), faces(count, 0);
    for (std::size_t f = 0; f < frame.faces.size(); ++f)
        for (const Index v : frame.faces[f]) {
            sum[v] += thickness[f];
            ++faces[v];
        }
    for (std::size_t v = 0; v < count; ++v)
        EXPECT_NEAR((mesh.vertices[v].position - mesh.vertices[count + v].position).norm(), sum[v] / faces[v],
                    0.03 * sum[v] / faces[v]);
}

TEST(RenderColour, TellsTwentyOneFragmentsApart) {
    std::set<std::uint32_t> colours;
    for (Index i = 0; i < 21; ++i) colours.insert(fragment_colour(i));
    EXPECT_EQ(colours.size(), 21u);
    EXPECT_EQ(fragment_colour(21), fragment_colour(0));
}

// Larger values must be brighter, so that a picture printed in grey can be read.
TEST(RenderColour, MapGrowsBrighter) {
    double before = -1;
    for (int i = 0; i <= 100; ++i) {
        const std::uint32_t c = map_colour(i / 100.0);
        const double grey = 0.299 * (c >> 16) + 0.587 * (c >> 8 & 255) + 0.114 * (c & 255);
        EXPECT_GT(grey, before - 0.6);  // tolerance: channels are integers
        before = grey;
    }
    EXPECT_EQ(map_colour(-3), map_colour(0));
    EXPECT_EQ(map_colour(7), map_colour(1));
}

TEST(RenderColour, StrainIsThatOfUnbrokenHinges) {
    Snapshot frame;
    frame.position = Positions::Zero(3, 3);
    frame.edges = {{0, 1}, {1, 2}, {2, 0}};
    frame.edge_state = {EdgeState::interior, EdgeState::interior, EdgeState::boundary};
    frame.edge_strain = {-2, 4, 0};
    EXPECT_EQ(render_scalar(frame, RenderColour::strain).values, (std::vector<double>{2, 3, 4}));
}

TEST(RenderColour, StressAndCurvatureAreMeansOfTheFacesAtAVertex) {
    Snapshot frame;
    frame.position = Positions::Zero(3, 4);
    frame.faces = {{0, 1, 2}, {0, 2, 3}};
    frame.fields.stress_top.resize(3, 2);
    frame.fields.stress_bottom.resize(3, 2);
    frame.fields.stress_top << 5, -1, 1, -2, 0, 0;
    frame.fields.stress_bottom << 2, 9, 0, 3, 0, 0;
    frame.fields.curvature.resize(3, 2);
    frame.fields.curvature << -4, 1, 1, 2, 0, 0;
    EXPECT_EQ(render_scalar(frame, RenderColour::stress).values, (std::vector<double>{7, 5, 7, 9}));
    EXPECT_EQ(render_scalar(frame, RenderColour::curvature).values, (std::vector<double>{3, 4, 3, 2}));
}

TEST(RenderColour, SaysHowToRecordWhatIsNotThere) {
    const std::string message = message_thrown_by([] { render_scalar({}, RenderColour::stress); });
    EXPECT_NE(message.find("output.fields = [\"stress\"]"), std::string::npos) << message;
    EXPECT_NE(message_thrown_by([] {
                  parse_render_colour("stres", render_colours);
              }).find("give fragment, strain, speed, stress, curvature, axis, tips, material or none"),
              std::string::npos);
}

// Stripes that do not follow the axis would show a wrong direction.
TEST(RenderStripes, RunAlongTheAxisAndAreAsFarApartAsWanted) {
    SyntheticRun run = synthetic_run();
    run.header.rest_position.row(2).setZero();
    const Vector3d axis(std::cos(0.5), std::sin(0.5), 0);
    const std::vector<Vector3d> axes(run.header.rest_faces.size(), axis);
    const Eigen::Matrix3Xd stripes = axis_stripes(run.header, axes, 0.01);
    for (std::size_t f = 0; f < axes.size(); ++f) {
        const auto& face = run.header.rest_faces[f];
        const Vector3d p = run.header.rest_position.col(face[0]), q = run.header.rest_position.col(face[1]);
        EXPECT_NEAR(stripes(1, f) - stripes(0, f), (q - p).dot(Vector3d::UnitZ().cross(axis)) / 0.01, 1e-4);
    }
}

constexpr int tube_columns = 60, tube_rows = 20;
constexpr double tube_radius = 0.1, tube_height = 0.25;

RecordingHeader tube() {
    RecordingHeader header;
    header.rest_position.resize(3, tube_columns * (tube_rows + 1));
    const auto number = [](int row, int column) { return row * tube_columns + column % tube_columns; };
    for (int row = 0; row <= tube_rows; ++row)
        for (int column = 0; column < tube_columns; ++column) {
            const double angle = 2 * std::numbers::pi * column / tube_columns;
            header.rest_position.col(number(row, column)) << tube_radius * std::cos(angle),
                tube_radius * std::sin(angle), tube_height * row / tube_rows;
            if (row == tube_rows) continue;
            const int a = number(row, column), b = number(row, column + 1), c = number(row + 1, column),
                      d = number(row + 1, column + 1);
            header.rest_faces.push_back({a, b, d});
            header.rest_faces.push_back({a, d, c});
        }
    for (const auto& [a, b, c] : header.rest_faces) {
        const Vector3d p = header.rest_position.col(a), q = header.rest_position.col(b),
                       r = header.rest_position.col(c);
        header.rest_area.push_back((q - p).cross(r - p).norm() / 2);
    }
    return header;
}

// Around a tube the phase of stripes must grow by a whole number of periods. A phase without jumps would have
// to run back somewhere, and show blotches.
TEST(RenderStripes, CloseAroundATube) {
    const RecordingHeader header = tube();
    const double circumference = 2 * tube_columns * tube_radius * std::sin(std::numbers::pi / tube_columns);
    for (const double wanted : {8.0, 7.7, 8.3}) {
        std::vector<Vector3d> axes;
        for (std::size_t f = 0; f < header.rest_faces.size(); ++f)
            axes.push_back(f % 3 == 0 ? Vector3d(-Vector3d::UnitZ()) : Vector3d::UnitZ());
        const Eigen::Matrix3Xd stripes = axis_stripes(header, axes, circumference / wanted / 2);
        // Follows each row of edges around the tube: the first sides of every second face in it.
        for (int row = 0; row < tube_rows; ++row) {
            double around = 0;
            for (int column = 0; column < tube_columns; ++column) {
                const int f = 2 * (row * tube_columns + column);
                const double growth = (stripes(1, f) - stripes(0, f)) * (f % 3 == 0 ? 1 : -1);
                EXPECT_NEAR(growth, 2 * 8.0 / tube_columns, 1e-3) << "the same everywhere";
                around += growth / 2;
            }
            EXPECT_NEAR(around, std::round(wanted), 1e-9);
        }
        // The phase must be constant along the axis, and neighbours must agree on every edge.
        for (std::size_t f = 0; f < axes.size(); f += 2) {
            EXPECT_NEAR(stripes(2, f), stripes(1, f), 1e-3);
            const double sign = axes[f].dot(axes[f + 1]);
            EXPECT_NEAR(stripes(2, f) - stripes(0, f), sign * (stripes(1, f + 1) - stripes(0, f + 1)), 1e-9);
            EXPECT_NEAR(std::remainder(stripes(0, f) - sign * stripes(0, f + 1), 2), 0, 1e-9);
        }
    }
}

/// Scene of a square, 1 m wide, that lies 1 m above the ground.
RenderScene square_above_ground() {
    RenderScene scene;
    RenderMesh square;
    for (const auto& [x, y] : {std::pair{-0.5f, -0.5f}, {0.5f, -0.5f}, {0.5f, 0.5f}, {-0.5f, 0.5f}})
        square.vertices.push_back({.position = {x, y, 1},
                                   .normal = Eigen::Vector3f::UnitZ(),
                                   .colour = {0.8f, 0.1f, 0.1f},
                                   .material = {x, y, 0}});
    square.triangles = {{0, 1, 2}, {0, 2, 3}};
    scene.meshes.push_back(square);
    scene.planes.push_back({Eigen::Vector3f::Zero(), Eigen::Vector3f::UnitZ()});
    scene.centre = Eigen::Vector3f::Zero();
    scene.up = Eigen::Vector3f::UnitZ();
    return scene;
}

const Camera from_above{{0, -0.01, 6}, {0, 0, 0}, {0, 0, 1}, 40};

TEST(RenderPicture, ShowsASquareAndItsShadow) {
    const auto picture = render_picture(square_above_ground(), from_above,
                                        {.width = 80, .height = 80, .samples = 16}, [] { return false; });
    ASSERT_TRUE(picture);
    const Eigen::Vector3f middle = picture->colour(40, 40), lit = picture->colour(12, 40);
    EXPECT_GT(middle.x(), 2 * middle.y()) << "red";
    EXPECT_NEAR(lit.x(), lit.z(), 0.1) << "grey ground";
    // The lamp is on the left, so the shadow lies to the right.
    const Eigen::Vector3f shadow = picture->colour(55, 36);
    EXPECT_LT(shadow.sum(), 0.75f * lit.sum());
}

TEST(RenderPicture, IsNoneWhenStopped) {
    EXPECT_FALSE(
        render_picture(square_above_ground(), from_above, {.width = 8, .height = 8}, [] { return true; }));
}

// An image that is written and read again must have its colours, rounded to bytes, and the same order of
// rows.
TEST(Image, PngKeepsWhatItIsGiven) {
    const TemporaryDirectory folder;
    Image image;
    image.width = 5;
    image.height = 3;
    image.colours = (Eigen::Matrix3Xf::Random(3, 15).array() + 1) / 2;
    const auto file = folder.write("image.png", png_bytes(image));
    const Image read = read_png(file);
    ASSERT_EQ(read.width, 5);
    ASSERT_EQ(read.height, 3);
    EXPECT_LT((read.colours - image.colours).cwiseAbs().maxCoeff(), 0.51f / 255);
}

}  // namespace
}  // namespace sherd::test
