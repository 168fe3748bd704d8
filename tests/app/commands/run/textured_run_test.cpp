// SPDX-License-Identifier: GPL-3.0-or-later
// If one of these tests failed, runs or exports would change the texture coordinates or materials of a mesh.
#include <gtest/gtest.h>

#include <fstream>
#include <set>

#include "app/recording/recording.h"
#include "meshops/attributes.h"
#include "meshops/face_groups.h"
#include "meshops/mesh_measures.h"
#include "meshops/read_write/read_mesh.h"
#include "meshops/shared_values.h"
#include "meshops/surface_material.h"
#include "tests/support/program/program.h"
#include "tests/support/program/temporary_directory.h"
#include "tests/support/recording/glb_content.h"
#include "tests/support/recording/same_snapshot.h"
#include "tests/support/recording/vtp_array.h"

namespace sherd::test {
namespace {

namespace fs = std::filesystem;

/// Texture coordinates of a place on the plate, on the left or right side of the seam at x = 0.
Eigen::Vector2d texture_at(const Vector3d& place, bool left) {
    return {2 * place.x() + 0.5 * place.y() + (left ? 3 : 0), 0.25 - 4 * place.y()};
}

/// OBJ file of a plate of 0.2 m about the origin, made of squares. Along x = 0 the texture has a seam, and
/// two materials meet.
std::string plate_obj() {
    constexpr int squares = 10;
    std::ostringstream points, texture, faces[2];
    const auto place = [](int i) { return 0.02 * i - 0.1; };
    for (int i = 0; i <= squares; ++i)
        for (int j = 0; j <= squares; ++j) {
            points << "v " << place(i) << " " << place(j) << " 0\n";
            for (const bool left : {true, false}) {
                const Eigen::Vector2d uv = texture_at({place(i), place(j), 0}, left);
                texture << "vt " << uv.x() << " " << uv.y() << "\n";
            }
        }
    const auto corner = [](int i, int j, bool left) {
        const int number = 11 * i + j;
        return " " + std::to_string(number + 1) + "/" + std::to_string(2 * number + (left ? 1 : 2));
    };
    for (int i = 0; i < squares; ++i)
        for (int j = 0; j < squares; ++j) {
            const bool left = i < squares / 2;
            faces[left ? 0 : 1] << "f" << corner(i, j, left) << corner(i + 1, j, left)
                                << corner(i + 1, j + 1, left) << corner(i, j + 1, left) << "\n";
        }
    return "mtllib looks.mtl\n" + points.str() + texture.str() + "usemtl glaze\n" + faces[0].str() +
           "usemtl bare clay\ng right half\no plate of two halves\n" + faces[1].str();
}

constexpr const char* looks =
    "newmtl glaze\nKd 0.1 0.2 0.6\nmap_Kd -s 1 1 pictures/blue glaze.png\nnewmtl bare clay\nKd 0.7 0.4 0.2\n"
    "newmtl unused\nKd 1 0 0\n";

/// PNG file of one pixel.
const std::string png(
    "\x89PNG\r\n\x1a\n\0\0\0\rIHDR\0\0\0\1\0\0\0\1\x8\2\0\0\0\x90wS\xde\0\0\0\xcIDATx\x9c\x63\x60\x60\x60\0\0"
    "\0"
    "\4\0\1\xf6\x17\x38\x55\0\0\0\0IEND\xae\x42\x60\x82",
    69);

/// Scene in which the plate falls edge first onto a floor and breaks.
constexpr const char* scene = R"(duration = 0.002
[sheet.plate]
mesh = "plate.obj"
material = { preset = "glass", thickness = 0.002 }
fracture = { strength = 1e6 }
place = { rotate = { axis = [1, 0, 0], degrees = 25 }, translate = [0, 0, 0.05] }
velocity = [0, 0, -6]
[obstacle.floor]
plane = { point = [0, 0, 0] }
[solver]
step = 1e-4
[output]
every = 5e-4
)";

class TexturedRun : public testing::Test {
  protected:
    void SetUp() override {
        folder.write("plate.obj", plate_obj());
        folder.write("looks.mtl", looks);
        fs::create_directory(folder.path / "pictures");
        folder.write("pictures/blue glaze.png", png);
        folder.write("scene.toml", scene);
        succeeds({"run", "scene.toml", "-o", "run.h5"});
    }
    void succeeds(const std::vector<std::string>& arguments) {
        const ProgramResult result = run_sherd(arguments, folder.path);
        ASSERT_EQ(result.exit_code, 0) << result.err;
    }
    Snapshot last() const {
        const Recording recording(folder.path / "run.h5");
        return recording.frame(recording.frame_count() - 1);
    }
    Mesh read(const std::string& name) const {
        std::vector<std::string> warnings;
        return read_mesh(folder.path / name, {.join_advice = ""}, warnings);
    }

    TemporaryDirectory folder;
};

/// Place of a corner of a recorded face on the unbroken plate, a flat mesh.
Vector3d in_plate(const RestMesh& rest, std::size_t face, int corner, const Mesh& plate) {
    const Vector3d weights = place_in_parent(rest, face, corner);
    Vector3d place = Vector3d::Zero();
    for (int k = 0; k < 3; ++k)
        place += weights[k] * position(plate, Vertex(rest.unfractured_faces[rest.face_parent[face]][k]));
    return place;
}

TEST_F(TexturedRun, KeepsCoordinatesAndMaterialsOfFacesThatBreak) {
    const Snapshot frame = last();
    const Mesh plate = read("plate.obj");
    ASSERT_GT(frame.position.cols(), frame.rest.position.cols()) << "nothing broke";
    ASSERT_EQ(frame.rest.look.texture.size(), frame.faces.size());
    ASSERT_EQ(frame.rest.look.material.size(), frame.faces.size());
    for (std::size_t f = 0; f < frame.faces.size(); ++f) {
        const std::string name = frame.rest.look.material[f]->name;
        Vector3d middle = Vector3d::Zero();
        for (int k = 0; k < 3; ++k) middle += in_plate(frame.rest, f, k, plate) / 3;
        EXPECT_EQ(name, middle.x() < 0 ? "glaze" : "bare clay");
        for (int k = 0; k < 3; ++k) {
            const Eigen::Vector2d expected = texture_at(in_plate(frame.rest, f, k, plate), name == "glaze");
            EXPECT_LT((frame.rest.look.texture[f][k] - expected).norm(), 1e-9)
                << "corner " << k << " of face " << f;
        }
    }
}

TEST_F(TexturedRun, ObjAndItsMaterialsAreReadBackAsTheyWereRecorded) {
    fs::create_directory(folder.path / "elsewhere");
    succeeds({"export", "run.h5", "--to", "obj", "--sheets-only", "-o", "elsewhere/last.obj"});
    const Snapshot frame = last();
    const Mesh mesh = read("elsewhere/last.obj");
    const auto [texture, has_texture] = find_property(mesh, attribute::texture);
    const auto [material, has_material] = find_property(mesh, attribute::surface_material);
    ASSERT_TRUE(has_texture && has_material);
    ASSERT_EQ(mesh.number_of_faces(), frame.faces.size());
    for (const Face face : mesh.faces()) {
        EXPECT_EQ(texture[face], frame.rest.look.texture[face.idx()]);
        EXPECT_EQ(*material[face], *frame.rest.look.material[face.idx()]);
    }
    const std::string mtl = folder.contents().at(folder.path / "elsewhere/last.mtl");
    EXPECT_NE(mtl.find("map_Kd -s 1 1 ../pictures/blue glaze.png\n"), std::string::npos) << mtl;
    EXPECT_EQ(mtl.find("unused"), std::string::npos);
}

// Users who put the handle of a cup in a group need it on the fragments.
TEST_F(TexturedRun, GroupsAndObjectsAreOnThePiecesAsGroups) {
    succeeds(
        {"export", "run.h5", "--to", "obj", "--sheets-only", "--fragments", "--solid", "-o", "last.obj"});
    succeeds({"export", "run.h5", "--to", "pvd", "--frames", "-1", "-o", "run.pvd"});
    const Snapshot frame = last();
    const auto shared = shared_values(frame.rest.look.groups);
    ASSERT_EQ(shared.rows, (std::vector<std::vector<std::string>>{{"right", "half", "plate of two halves"}}));
    for (std::size_t f = 0; f < frame.faces.size(); ++f)
        EXPECT_EQ(shared.number[f], frame.rest.look.material[f]->name == "glaze" ? -1 : 0);
    const Mesh mesh = read("last.obj");
    const auto groups = find_property(mesh, attribute::groups).first;
    const auto material = find_property(mesh, attribute::surface_material).first;
    for (const Face face : mesh.faces()) {
        const std::vector<std::string>& names = *groups[face];
        EXPECT_TRUE(names.back().starts_with("fragment_"));
        if ((*material[face]).name == "inside") continue;
        const bool is_right = (*material[face]).name == "bare clay";
        EXPECT_EQ(names.size(), is_right ? 4u : 1u);
        if (is_right) {
            EXPECT_EQ(names[2], "plate_of_two_halves");
        }
    }
    const std::string vtp = folder.contents().at(folder.path / "run_000004.vtp");
    EXPECT_EQ(vtp_array<std::int32_t>(vtp, "Int32", "group"), shared.number);
    EXPECT_NE(vtp.find("Name=\"group_names\" NumberOfTuples=\"1\""), std::string::npos);
}

// Artists give the broken sides a texture of their own, which must have the scale of the object.
TEST_F(TexturedRun, BrokenSidesOfSolidsAreInsideAndMeasuredInMetres) {
    succeeds({"export", "run.h5", "--to", "obj", "--sheets-only", "--solid", "-o", "solid.obj"});
    const Mesh mesh = read("solid.obj");
    const auto [texture, has_texture] = find_property(mesh, attribute::texture);
    const auto [material, has_material] = find_property(mesh, attribute::surface_material);
    ASSERT_TRUE(has_texture && has_material);
    const std::size_t faces = last().faces.size();
    std::size_t inside = 0;
    for (const Face face : mesh.faces()) {
        if (face.idx() < 2 * faces) {
            EXPECT_NE((*material[face]).name, "inside");
            continue;
        }
        if ((*material[face]).name != "inside") continue;
        ++inside;
        const Eigen::Vector2d a = texture[face][1] - texture[face][0],
                              b = texture[face][2] - texture[face][0];
        const double area = std::abs(a.x() * b.y() - a.y() * b.x()) / 2;
        EXPECT_NEAR(area, face_area(mesh, face), 0.1 * area) << "the sides are about as long as they were";
        for (const Eigen::Vector2d& uv : texture[face]) EXPECT_TRUE(uv.y() == 0 || uv.y() == 0.002);
    }
    EXPECT_GT(inside, 0u);
    for (std::size_t f = 0; f < faces; ++f) EXPECT_EQ(texture[Face(f)][0], texture[Face(faces + f)][0]);
}

TEST_F(TexturedRun, GlbSplitsVerticesAtSeamsOnlyAndTurnsV) {
    succeeds({"export", "run.h5", "--to", "glb", "--sheets-only", "-o", "run.glb"});
    const Glb glb(folder.contents().at(folder.path / "run.glb"));
    const Snapshot frame = last();
    std::set<std::array<float, 2>> expected, found;
    for (const FaceTexture& corners : frame.rest.look.texture)
        for (const Eigen::Vector2d& uv : corners)
            expected.insert({static_cast<float>(uv.x()), static_cast<float>(1 - uv.y())});
    std::size_t vertices = 0;
    for (const nlohmann::json& mesh : glb.json["meshes"]) {
        const nlohmann::json& attributes = mesh["primitives"][0]["attributes"];
        const auto uv = glb.values<float>(attributes["TEXCOORD_0"].get<std::size_t>(), 2);
        EXPECT_EQ(uv.size() / 2, glb.cloud(attributes["POSITION"].get<std::size_t>()).size());
        EXPECT_EQ(uv.size() / 2, glb.cloud(attributes["NORMAL"].get<std::size_t>()).size());
        for (std::size_t i = 0; i < uv.size(); i += 2) found.insert({uv[i], uv[i + 1]});
        vertices += uv.size() / 2;
    }
    EXPECT_EQ(found, expected);
    EXPECT_LE(vertices, static_cast<std::size_t>(frame.position.cols()) + 2 * 11) << "only the seam is split";
}

/// Names of the materials of a mesh's parts.
std::set<std::string> part_materials(const Glb& glb) {
    std::set<std::string> names;
    for (const nlohmann::json& mesh : glb.json["meshes"])
        for (const nlohmann::json& part : mesh["primitives"])
            names.insert(glb.json["materials"][part["material"].get<std::size_t>()]["name"]);
    return names;
}

// Without materials in the file, artists would have to set up every material of every shot again.
TEST_F(TexturedRun, GlbHasTheMaterialsAndTheirPictures) {
    succeeds({"export", "run.h5", "--to", "glb", "--sheets-only", "--solid", "-o", "run.glb"});
    const Glb glb(folder.contents().at(folder.path / "run.glb"));
    EXPECT_EQ(part_materials(glb), (std::set<std::string>{"glaze", "bare clay", "inside"}));
    for (const nlohmann::json& material : glb.json["materials"]) {
        const nlohmann::json& look = material["pbrMetallicRoughness"];
        const bool has_picture = material["name"] == "glaze";
        EXPECT_EQ(look.contains("baseColorTexture"), has_picture);
        if (material["name"] == "bare clay") {
            EXPECT_NEAR(look["baseColorFactor"][0], 0.7, 1e-6);
        }
    }
    ASSERT_EQ(glb.json["images"].size(), 1u);
    EXPECT_EQ(glb.json["images"][0]["mimeType"], "image/png");
    const nlohmann::json& view =
        glb.json["bufferViews"][glb.json["images"][0]["bufferView"].get<std::size_t>()];
    EXPECT_EQ(glb.data.substr(view["byteOffset"], view["byteLength"]), png);
}

TEST_F(TexturedRun, APictureThatIsNotThereIsToldAndTheRestIsWritten) {
    fs::remove(folder.path / "pictures/blue glaze.png");
    const ProgramResult result = run_sherd({"export", "run.h5", "--to", "glb", "-o", "run.glb"}, folder.path);
    EXPECT_EQ(result.exit_code, 0);
    EXPECT_NE(result.err.find("pictures/blue glaze.png: the picture cannot be read"), std::string::npos)
        << result.err;
    const Glb glb(folder.contents().at(folder.path / "run.glb"));
    EXPECT_FALSE(glb.json.contains("images"));
}

// A fragment whose broken edges are shaded smoothly looks like soap.
TEST_F(TexturedRun, NormalsOfSolidsAreSmoothOutsideAndHardAtTheBreak) {
    succeeds({"export", "run.h5", "--to", "glb", "--sheets-only", "--solid", "-o", "run.glb"});
    const Glb glb(folder.contents().at(folder.path / "run.glb"));
    std::size_t broken = 0;
    for (const nlohmann::json& mesh : glb.json["meshes"])
        for (const nlohmann::json& part : mesh["primitives"]) {
            const std::string name = glb.json["materials"][part["material"].get<std::size_t>()]["name"];
            if (name != "inside") continue;
            const Cloud points = glb.cloud(part["attributes"]["POSITION"].get<std::size_t>()),
                        normals = glb.cloud(part["attributes"]["NORMAL"].get<std::size_t>());
            const auto corners = glb.values<std::uint32_t>(part["indices"].get<std::size_t>(), 1);
            for (std::size_t i = 0; i < corners.size(); i += 3) {
                const Eigen::Vector3f& a = points[corners[i]];
                const Eigen::Vector3f flat =
                    (points[corners[i + 1]] - a).cross(points[corners[i + 2]] - a).normalized();
                for (int k = 0; k < 3; ++k) EXPECT_GT(normals[corners[i + k]].dot(flat), 0.9);
                ++broken;
            }
        }
    EXPECT_GT(broken, 0u);
}

// ParaView needs texture coordinates and numbers of materials to show a picture on the sheet.
TEST_F(TexturedRun, VtpHasTextureCoordinatesOfPointsAndMaterialsOfFaces) {
    succeeds({"export", "run.h5", "--to", "pvd", "--frames", "-1", "-o", "run.pvd"});
    const std::string vtp = folder.contents().at(folder.path / "run_000004.vtp");
    EXPECT_NE(vtp.find("TCoords=\"texture\""), std::string::npos);
    const Snapshot frame = last();
    const auto texture = vtp_array<double>(vtp, "Float64", "texture");
    const auto corners = vtp_array<std::int32_t>(vtp, "Int32", "connectivity");
    for (std::size_t f = 0; f < frame.faces.size(); ++f)
        for (int i = 0; i < 6; ++i)
            EXPECT_EQ(texture[2 * corners[3 * f + i / 2] + i % 2], frame.rest.look.texture[f][i / 2][i % 2]);
    EXPECT_EQ(vtp_array<std::int32_t>(vtp, "Int32", "material"),
              shared_values(frame.rest.look.material).number);
}

/// The plate as a .ply file, in which colours depend on the place.
std::string painted_plate() {
    std::ostringstream ply;
    ply << "ply\nformat ascii 1.0\nelement vertex 121\nproperty float x\nproperty float y\nproperty float z\n"
           "property uchar red\nproperty uchar green\nproperty uchar blue\nelement face 100\n"
           "property list uchar int vertex_indices\nproperty uchar red\nproperty uchar green\n"
           "property uchar blue\nend_header\n";
    for (int i = 0; i <= 10; ++i)
        for (int j = 0; j <= 10; ++j)
            ply << 0.02 * i - 0.1 << " " << 0.02 * j - 0.1 << " 0 " << 20 * i << " " << 20 * j << " 9\n";
    for (int i = 0; i < 10; ++i)
        for (int j = 0; j < 10; ++j) {
            const int a = 11 * i + j;
            ply << "4 " << a << " " << a + 11 << " " << a + 12 << " " << a + 1 << " " << (i < 5 ? 1 : 2)
                << " 3 4\n";
        }
    return ply.str();
}

// If pieces lost the colours of their places, a painted scan would break into white pieces.
TEST_F(TexturedRun, ColoursOfPlyAreThoseOfTheirPlacesOnThePieces) {
    folder.write("plate.ply", painted_plate());
    succeeds({"run", "scene.toml", "-o", "painted.h5", "--set", "sheet.plate.mesh=plate.ply"});
    succeeds({"export", "painted.h5", "--to", "ply", "--sheets-only", "-o", "painted.ply"});
    succeeds({"export", "painted.h5", "--to", "glb", "--sheets-only", "-o", "painted.glb"});
    const Recording recording(folder.path / "painted.h5");
    const Snapshot frame = recording.frame(recording.frame_count() - 1);
    ASSERT_GT(frame.position.cols(), frame.rest.position.cols()) << "nothing broke";
    const Mesh plate = read("plate.ply"), mesh = read("painted.ply");
    const auto vertex = find_property(mesh, attribute::vertex_colour).first;
    const auto face = find_property(mesh, attribute::face_colour).first;
    for (std::size_t f = 0; f < frame.faces.size(); ++f) {
        Vector3d middle = Vector3d::Zero();
        for (int k = 0; k < 3; ++k) {
            const Vector3d place = in_plate(frame.rest, f, k, plate);
            middle += place / 3;
            const Colour& colour = vertex[Vertex(frame.faces[f][k])];
            EXPECT_NEAR(colour[0], 1000 * (place.x() + 0.1), 0.51);
            EXPECT_NEAR(colour[1], 1000 * (place.y() + 0.1), 0.51);
        }
        if (std::abs(middle.x()) > 0.01) {
            EXPECT_EQ(face[Face(f)][0], middle.x() < 0 ? 1 : 2);
        }
    }
    const Glb glb(folder.contents().at(folder.path / "painted.glb"));
    for (const nlohmann::json& fragment : glb.json["meshes"])
        EXPECT_TRUE(fragment["primitives"][0]["attributes"].contains("COLOR_0"));
}

// A run resumed from a checkpoint must keep textures, materials and colours of earlier fragments.
TEST_F(TexturedRun, LooksOfWhatBrokeGoOnWithTheRun) {
    folder.write("plate.ply", painted_plate());
    for (const std::string mesh : {"plate.obj", "plate.ply"}) {
        const auto run = [&](const std::string& output, const std::vector<std::string>& more) {
            std::vector<std::string> arguments{
                "run",   "scene.toml",
                "-o",    output,
                "--set", "sheet.plate.mesh=" + mesh,
                "--set", "sheet.plate.fracture={ strength = 1e6, toughness = 2e5 }"};
            arguments.insert(arguments.end(), more.begin(), more.end());
            succeeds(arguments);
        };
        run(mesh + "-whole.h5", {});
        run(mesh + "-half.h5", {"--until", "0.0016"});
        const Recording half(folder.path / (mesh + "-half.h5"));
        const Snapshot before = half.frame(half.frame_count() - 1);
        ASSERT_GT(before.faces.size(), before.rest.unfractured_faces.size()) << "no crack has split a face";
        run(mesh + "-half.h5", {"--resume"});
        const Recording whole(folder.path / (mesh + "-whole.h5")), resumed(folder.path / (mesh + "-half.h5"));
        ASSERT_EQ(resumed.frame_count(), whole.frame_count());
        for (std::size_t i = 0; i < whole.frame_count(); ++i) expect_same(resumed.frame(i), whole.frame(i));
    }
}

}  // namespace
}  // namespace sherd::test
