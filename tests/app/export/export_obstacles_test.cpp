// SPDX-License-Identifier: GPL-3.0-or-later
// Obstacles and free bodies in every format, read back: in other programs fragments must lie on them, and be
// hit by them, in the right place.
#include "app/export/export_obstacles.h"

#include <fmt/format.h>
#include <openvdb/io/File.h>
#include <openvdb/openvdb.h>

#include <cmath>
#include <fstream>
#include <map>

#include "app/json/json.h"
#include "app/playback/interpolation.h"
#include "app/playback/playback.h"
#include "meshops/read_write/stl.h"
#include "tests/support/program/program.h"
#include "tests/support/recording/export_fixture.h"
#include "tests/support/recording/glb_content.h"
#include "tests/support/recording/recorded_obstacles.h"
#include "tests/support/recording/vtp_array.h"

namespace sherd::test {
namespace {

namespace fs = std::filesystem;

const std::vector<std::string> names{"obstacle_a_b__anvil_", "obstacle_a_b__anvil__2", "obstacle_floor"};

/// Two recordings: with.h5 has two tetrahedra, the second of which moves, and a floor; run.h5 has no
/// obstacles.
class ExportObstacles : public Export {
  protected:
    ExportObstacles() { record_with_obstacles(run, folder.path / "with.h5"); }

    ExportOptions with(const std::string& format, const std::string& output) const {
        ExportOptions wanted = options(format, output);
        wanted.recording = folder.path / "with.h5";
        return wanted;
    }

    /// Expects that an export without obstacles equals the export of a recording that has none, except for
    /// the recording's name in glb.
    void expect_left_out(ExportOptions wanted, const std::string& extension) const {
        wanted.sheets_only = true;
        wanted.output = folder.path / ("left_out" + extension);
        const std::size_t files = export_recording(wanted).files.size();
        wanted.recording = folder.path / "run.h5";
        wanted.output = folder.path / ("none" + extension);
        EXPECT_EQ(export_recording(wanted).files.size(), files);
        if (files > 1) return;
        const std::string left_out = bytes("left_out" + extension);
        if (extension == ".glb")
            EXPECT_EQ(left_out.find("obstacle"), std::string::npos);
        else
            EXPECT_EQ(left_out, bytes("none" + extension));
    }
};

void expect_points(const Mesh& mesh, const std::vector<Vector3d>& expected) {
    ASSERT_EQ(mesh.number_of_vertices(), expected.size());
    for (const Vertex v : mesh.vertices()) {
        const Point& point = mesh.point(v);
        EXPECT_LT((Vector3d(point.x(), point.y(), point.z()) - expected[v.idx()]).norm(), 1e-15);
    }
}

/// Object of an OBJ file: its points, and for each face the three numbers of its corners as they are in the
/// file.
struct ObjObject {
    std::vector<Vector3d> points;
    std::vector<std::array<int, 3>> faces;
};

std::map<std::string, ObjObject> objects_of(const fs::path& file) {
    std::ifstream stream(file);
    std::map<std::string, ObjObject> objects;
    std::string object, kind;
    while (stream >> kind) {
        if (kind == "o") stream >> object;
        if (kind == "v") {
            Vector3d& point = objects[object].points.emplace_back();
            stream >> point.x() >> point.y() >> point.z();
        } else if (kind == "f") {
            auto& [a, b, c] = objects[object].faces.emplace_back();
            stream >> a >> b >> c;
        }
    }
    return objects;
}

// Blender hides and moves objects one by one, so that obstacles must be objects; the vertices of the sheets
// must keep their numbers.
TEST_F(ExportObstacles, AreObjectsOfAnObj) {
    ExportOptions wanted = with("obj", "out.obj");
    export_recording(wanted);
    auto objects = objects_of(wanted.output);
    ASSERT_EQ(objects.size(), 4u);
    const Snapshot& frame = run.frames.back();
    ASSERT_EQ(objects["sheets"].points.size(), frame.original.size());
    for (std::size_t f = 0; f < frame.faces.size(); ++f)
        for (int k = 0; k < 3; ++k) EXPECT_EQ(objects["sheets"].faces[f][k], frame.faces[f][k] + 1);
    int first = static_cast<int>(frame.original.size()) + 1;
    for (std::size_t i = 0; i < names.size(); ++i) {
        EXPECT_EQ(objects[names[i]].points, obstacle_points(i, 2)) << names[i];
        const auto triangles = recorded_obstacles()[i].surface.triangles;
        ASSERT_EQ(objects[names[i]].faces.size(), triangles.size());
        for (std::size_t t = 0; t < triangles.size(); ++t)
            for (int k = 0; k < 3; ++k) EXPECT_EQ(objects[names[i]].faces[t][k], first + triangles[t][k]);
        first += static_cast<int>(objects[names[i]].points.size());
    }
    wanted.fragments = wanted.force = true;
    export_recording(wanted);
    EXPECT_EQ(objects_of(wanted.output).size(), 6u) << "three fragments";
    expect_left_out(with("obj", ""), ".obj");
}

// A PLY or STL file holds one mesh, in which obstacles would merge with the sheets.
TEST_F(ExportObstacles, AreFilesOfTheirOwnInPlyAndStl) {
    ExportOptions wanted = with("ply", "out.ply");
    wanted.frames = "0,2";
    const auto files = export_recording(wanted).files;
    ASSERT_EQ(files.size(), 8u);
    EXPECT_EQ(files[1], folder.path / ("out_000000_" + names[0] + ".ply"));
    for (const std::size_t frame : {0, 2})
        for (std::size_t i = 0; i < names.size(); ++i)
            expect_points(read(fmt::format("out_00000{}_{}.ply", frame, names[i])),
                          obstacle_points(i, frame));
    export_recording(with("stl", "out.stl"));
    EXPECT_EQ(bytes("out_obstacle_floor.stl"),
              stl_bytes(placed(floor_plane().surface, obstacle_poses(2)[2])));
    expect_left_out(with("ply", ""), ".ply");
    expect_left_out(with("stl", ""), ".stl");
}

// Obstacles must be where pictures and pages show them, also between two keys of the animation. Obstacles at
// rest must have no animation.
TEST_F(ExportObstacles, AreNodesOfAGlbThatMove) {
    export_recording(with("glb", "out.glb"));
    const Glb glb(bytes("out.glb"));
    ASSERT_EQ(glb.json["nodes"][0]["children"].size(), 6u);
    for (std::size_t i = 0; i < names.size(); ++i) {
        const std::size_t node = glb.json["nodes"][0]["children"][3 + i];
        const auto& found = glb.json["nodes"][node];
        EXPECT_EQ(found["name"], names[i]);
        const auto& primitive = glb.primitive(found);
        EXPECT_EQ(glb.json["materials"][primitive["material"].get<std::size_t>()]["name"], "obstacle");
        const Cloud points = glb.cloud(primitive["attributes"]["POSITION"]);
        for (const auto& normal : glb.cloud(primitive["attributes"]["NORMAL"]))
            EXPECT_NEAR(normal.norm(), 1, 1e-6);
        const auto indices = glb.values<std::uint32_t>(primitive["indices"], 1);
        const GridSurface surface = recorded_obstacles()[i].surface;
        const auto expect_at = [&](const Eigen::Vector3f& t, const Eigen::Quaternionf& q,
                                   const Eigen::Isometry3d& pose) {
            for (std::size_t c = 0; c < indices.size(); ++c) {
                const Vector3d expected = pose * surface.points[surface.triangles[c / 3][c % 3]];
                EXPECT_LT((q * points[indices[c]] + t - expected.cast<float>()).norm(), 1e-7F) << names[i];
            }
        };
        if (i != 1) {
            EXPECT_THROW(glb.track(node, "translation"), std::out_of_range) << "it rests";
            std::array<float, 3> t;
            std::array<float, 4> q;
            for (int k = 0; k < 3; ++k) t[k] = found["translation"][k];
            for (int k = 0; k < 4; ++k) q[k] = found["rotation"][k];
            expect_at(Eigen::Vector3f(t.data()), Eigen::Quaternionf(q.data()), obstacle_poses(0)[i]);
            continue;
        }
        const auto t = glb.values<float>(glb.track(node, "translation"), 3),
                   q = glb.values<float>(glb.track(node, "rotation"), 4);
        const auto place = [&](std::size_t k) { return Eigen::Vector3f(&t[3 * k]); };
        const auto turn = [&](std::size_t k) { return Eigen::Quaternionf(&q[4 * k]); };
        for (std::size_t k = 0; k < 3; ++k) expect_at(place(k), turn(k), obstacle_poses(k)[i]);
        const Eigen::Vector3f half_way = 0.5F * (place(0) + place(1));
        expect_at(half_way, turn(0).slerp(0.5F, turn(1)),
                  interpolated(obstacle_poses(0)[i], obstacle_poses(1)[i], 0.5, middle(surface)));
    }
    expect_left_out(with("glb", ""), ".glb");
}

// Triangles of a tetrahedron meet at sharp edges, where each needs corners of its own. The two triangles of a
// square share their corners.
TEST_F(ExportObstacles, KeepSharpEdgesInAGlb) {
    export_recording(with("glb", "out.glb"));
    const Glb glb(bytes("out.glb"));
    const auto corners = [&](std::size_t child) {
        const std::size_t node = glb.json["nodes"][0]["children"][child];
        return glb.cloud(glb.primitive(glb.json["nodes"][node])["attributes"]["POSITION"]).size();
    };
    EXPECT_EQ(corners(3), 12u);
    EXPECT_EQ(corners(5), 4u);
}

// Other engines need the obstacles on which fragments lie.
TEST_F(ExportObstacles, AreInTheTableOfFragments) {
    ExportOptions wanted = with("fragments", "pieces.csv");
    wanted.thickness = 0.002;
    export_recording(wanted);
    const Json table = Json::parse(bytes("pieces.json"));
    ASSERT_EQ(table["obstacles"].size(), 3u);
    for (std::size_t i = 0; i < names.size(); ++i) {
        EXPECT_EQ(table["obstacles"][i]["obstacle"], names[i]);
        EXPECT_EQ(table["obstacles"][i]["plane"], i == 2);
        expect_points(read(table["obstacles"][i]["body"]), obstacle_points(i, 2));
    }
    EXPECT_EQ(bytes("pieces.csv").find("obstacle"), std::string::npos);
    expect_left_out(wanted, ".csv");
}

std::vector<double> numbers_of(const std::vector<Vector3d>& points) {
    std::vector<double> numbers;
    for (const Vector3d& point : points) numbers.insert(numbers.end(), point.begin(), point.end());
    return numbers;
}

// ParaView shows the parts of one time together. Obstacles at rest must be written only once.
TEST_F(ExportObstacles, ArePartsOfAPvd) {
    const auto files = export_recording(with("pvd", "out.pvd")).files;
    ASSERT_EQ(files.size(), 3 + 3 + 2 + 1u);
    const std::string index = bytes("out.pvd");
    for (std::size_t frame = 0; frame < 3; ++frame) {
        const std::array<std::string, 4> parts{
            fmt::format("out_00000{}.vtp", frame), "out_" + names[0] + ".vtp",
            fmt::format("out_00000{}_{}.vtp", frame, names[1]), "out_" + names[2] + ".vtp"};
        for (std::size_t part = 0; part < parts.size(); ++part) {
            const std::string line = fmt::format(
                "<DataSet timestep=\"{:.17g}\" part=\"{}\" name=\"{}\" file=\"{}\"/>", run.frames[frame].time,
                part, part == 0 ? "sheets" : names[part - 1], parts[part]);
            EXPECT_NE(index.find(line), std::string::npos) << line;
            if (part == 0) continue;
            EXPECT_EQ(vtp_array<double>(bytes(parts[part]), "Float64", "Points"),
                      numbers_of(obstacle_points(part - 1, frame)));
            const auto corners = vtp_array<Index>(bytes(parts[part]), "Int32", "connectivity");
            EXPECT_EQ(corners.size(), 3 * recorded_obstacles()[part - 1].surface.triangles.size());
        }
    }
    expect_left_out(with("pvd", ""), ".pvd");
}

// A cache belongs to one mesh: the cache of the sheets must be the same as without obstacles, and each moving
// obstacle must have its own.
TEST_F(ExportObstacles, HaveMeshesAndCachesOfTheirOwn) {
    ExportOptions wanted = with("pc2", "out.pc2");
    wanted.slow = {1, 20};  // twice as many samples as frames
    EXPECT_EQ(export_recording(wanted).files.size(), 2 + 1 + 2 + 1u);
    for (std::size_t i = 0; i < names.size(); ++i) {
        expect_points(read("out_" + names[i] + ".obj"), obstacle_points(i, 0));
        EXPECT_EQ(fs::exists(folder.path / ("out_" + names[i] + ".pc2")), i == 1);
    }
    const GridSurface surface = recorded_obstacles()[1].surface;
    const auto half_way = interpolated(obstacle_poses(0)[1], obstacle_poses(1)[1], 0.5, middle(surface));
    Bytes pc2(bytes("out_" + names[1] + ".pc2"), 16);
    EXPECT_EQ(pc2.next<std::int32_t>(), 4);
    Bytes samples(bytes("out_" + names[1] + ".pc2"), 28);
    ASSERT_EQ(samples.next<std::int32_t>(), 5);
    for (const Eigen::Isometry3d& pose : {obstacle_poses(0)[1], half_way, obstacle_poses(1)[1]})
        for (const Vector3d& point : surface.points)
            for (const double x : pose* point) EXPECT_NEAR(samples.next<float>(), x, 1e-8);
    wanted = with("mdd", "out.mdd");
    wanted.force = true;
    export_recording(wanted);
    EXPECT_TRUE(fs::exists(folder.path / ("out_" + names[1] + ".mdd")));
    expect_left_out(with("pc2", ""), ".pc2");
}

// Hollow or misplaced grids would let smoke through the obstacle.
TEST_F(ExportObstacles, AreGridsOfAVdb) {
    const ExportReport report = export_recording(with("vdb", "out.vdb"));
    EXPECT_TRUE(report.warnings.empty()) << report.warnings.front();
    openvdb::initialize();
    openvdb::io::File file((folder.path / "out.vdb").string());
    file.open();
    EXPECT_TRUE(file.hasGrid("surface"));
    EXPECT_FALSE(file.hasGrid(names[2])) << "a plane has no end";
    for (std::size_t i = 0; i < 2; ++i) {
        const auto grid = openvdb::gridPtrCast<openvdb::FloatGrid>(file.readGrid(names[i]));
        ASSERT_TRUE(grid);
        EXPECT_EQ(grid->getGridClass(), openvdb::GRID_LEVEL_SET);
        const auto at = [&](const Vector3d& place) {
            return grid->tree().getValue(
                grid->transform().worldToIndexCellCentered({place.x(), place.y(), place.z()}));
        };
        const std::vector<Vector3d> points = obstacle_points(i, 2);
        const Vector3d centre = (points[0] + points[1] + points[2] + points[3]) / 4;
        const auto voxel = static_cast<float>(grid->voxelSize()[0]);
        EXPECT_FLOAT_EQ(at(centre), -3 * voxel);
        EXPECT_FLOAT_EQ(at(2 * points[1] - centre), 3 * voxel);
        EXPECT_LT(std::abs(at((points[0] + points[1] + points[2]) / 3)), voxel) << "on a face";
    }
    expect_left_out(with("vdb", ""), ".vdb");
}

/// Scene of a sheet in the air, with a floor, a box that moves by keys, and a free ball away from the sheet.
const std::string falling = R"(duration = 0.002
[sheet.plate]
mesh = { generate = "rectangle", width = 0.1, height = 0.1, edge_length = 0.02 }
material = { preset = "glass", thickness = 0.002 }
[obstacle.floor]
plane = { point = [0, 0, -1] }
[obstacle.ram]
box = { size = [0.1, 0.1, 0.1] }
place = { translate = [0, 0, 0.5] }
keys = [{ time = 0 }, { time = 0.002, translate = [0, 0, 0.01] }]
[obstacle.ball]
sphere = { radius = 0.02, centre = [0.3, 0.1, 0.2] }
density = 7850
velocity = [0, 0, -2]
[solver]
step = 1e-3
[output]
every = 1e-3
)";

// Runs and exports through the real program: obstacles of a real run must be exported where they were.
TEST(ExportedRun, HasItsObstaclesWhereTheyWere) {
    const TemporaryDirectory folder;
    folder.write("scene.toml", falling);
    const auto succeeds = [&](const std::vector<std::string>& arguments) {
        const ProgramResult result = run_sherd(arguments, folder.path);
        EXPECT_EQ(result.exit_code, 0) << result.err;
    };
    succeeds({"run", "scene.toml", "-o", "run.h5"});
    succeeds({"export", "run.h5", "--to", "obj", "-o", "last.obj"});
    succeeds({"export", "run.h5", "--to", "obj", "-o", "alone.obj", "--sheets-only"});
    auto objects = objects_of(folder.path / "last.obj");
    ASSERT_EQ(objects.size(), 4u);
    const auto box = [&](const std::string& name) {
        Eigen::AlignedBox3d box;
        for (const Vector3d& point : objects[name].points) box.extend(point);
        return box;
    };
    EXPECT_LT((box("obstacle_ram").center() - Vector3d(0, 0, 0.51)).norm(), 1e-12);
    EXPECT_LT((box("obstacle_ram").sizes() - Vector3d(0.1, 0.1, 0.1)).norm(), 1e-12);
    EXPECT_LT((box("obstacle_ball").center() - Vector3d(0.3, 0.1, 0.196)).norm(), 5e-5);
    EXPECT_EQ(box("obstacle_floor").min().z(), -1);
    EXPECT_TRUE(box("obstacle_floor").contains(Vector3d(0.3, 0.1, -1)));
    const auto alone = objects_of(folder.path / "alone.obj");
    ASSERT_EQ(alone.size(), 1u);
    EXPECT_EQ(alone.at("").points, objects["sheets"].points);
}

// OpenVDB would fill an open surface from outside, or not at all.
TEST_F(ExportObstacles, ThatAreOpenHaveNoGrid) {
    {
        RecordedObstacle open = tetrahedron();
        open.surface.triangles.pop_back();
        RecordingWriter writer(folder.path / "open.h5", run.header, false, {{open}});
        const Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
        writer.append(run.frames[0], run.steps[0], run.events[0], {{pose}});
    }
    ExportOptions wanted = with("vdb", "out.vdb");
    wanted.recording = folder.path / "open.h5";
    const ExportReport report = export_recording(wanted);
    ASSERT_EQ(report.warnings.size(), 1u);
    EXPECT_EQ(report.warnings[0], names[0] + " is not closed, so it has no level set in the .vdb");
}

}  // namespace
}  // namespace sherd::test
