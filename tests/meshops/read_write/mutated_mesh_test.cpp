// SPDX-License-Identifier: GPL-3.0-or-later
// Mesh files damaged in a thousand ways: each must give an Error or a mesh, without ending the program or
// taking more memory than a small multiple of the file.
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <random>

#include "meshops/error.h"
#include "meshops/read_write/read_mesh.h"
#include "meshops/read_write/stl.h"
#include "meshops/read_write/write_mesh.h"
#include "tests/support/mesh/mesh_shapes.h"
#include "tests/support/mesh/ply_square.h"
#include "tests/support/program/temporary_directory.h"

namespace sherd::test {
namespace {

using Generator = std::mt19937;  // gives the same numbers on every platform, unlike std's distributions

std::size_t below(Generator& random, std::size_t count) {
    return random() % count;
}

/// Words with a meaning in any of the mesh formats.
const std::vector<std::string> words{"-1",
                                     "nan",
                                     "inf",
                                     "1e999",
                                     "4294967295",
                                     "18446744073709551616",
                                     "99999999999",
                                     "0",
                                     "element",
                                     "property list uint uint a\n",
                                     "property int x\n",
                                     "element vertex 9\n",
                                     "end_header\n",
                                     "\n",
                                     " ",
                                     "#",
                                     "/",
                                     "\\\n",
                                     std::string(1, '\0'),
                                     "\xff\xff\xff\xff",
                                     "BINARY",
                                     "ST",
                                     "4",
                                     "facet",
                                     "endsolid",
                                     "f 1 2 3\n",
                                     "o a b\n",
                                     "vt nan nan\n"};

std::string mutated(std::string text, Generator& random) {
    for (std::size_t change = 0; change <= below(random, 3); ++change) {
        if (text.empty()) return text;
        const std::size_t at = below(random, text.size()), size = 1 + below(random, 8);
        switch (below(random, 6)) {
            case 0:
                text[at] = static_cast<char>(random());
                break;
            case 1:
                text.erase(at, size);
                break;
            case 2:
                text.insert(at, words[below(random, words.size())]);
                break;
            case 3:
                text.insert(at, text.substr(below(random, text.size()), size));
                break;
            case 4:
                text.resize(at);
                break;
            default:
                text[at] = static_cast<char>(text[at] ^ (1 << below(random, 8)));
        }
    }
    return text;
}

/// Names of mesh files, which determine the format, and their contents.
std::vector<std::pair<std::string, std::string>> originals() {
    TriangleSheet sheet = triangle_sheet(octahedron());
    const std::string stl = stl_bytes(sheet), off = mesh_bytes(sheet, "a.off");
    sheet.look.texture.resize(8, {Eigen::Vector2d(0, 0), Eigen::Vector2d(1, 0), Eigen::Vector2d(0, 1)});
    sheet.look.axis.resize(8, Eigen::Vector3d(1, 0, 0));
    sheet.look.groups.resize(
        8, std::make_shared<const std::vector<std::string>>(std::vector<std::string>{"low"}));
    return {{"a.ply", mesh_bytes(sheet, "a.ply")},
            {"a.ply", ply_square("1 0 0", "0 1 0")},
            {"a.off", off},
            {"a.off", "ST" + off},
            {"a.obj", mesh_bytes(sheet, "a.obj")},
            {"a.stl", stl},
            {"a.stl",
             "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\n"
             "endfacet\nendsolid a\n"}};
}

std::size_t peak_memory() {  // bytes
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return static_cast<std::size_t>(usage.ru_maxrss) * 1024;
}

TEST(MutatedMesh, IsAnErrorOrAMesh) {
    const TemporaryDirectory directory;
    std::vector<std::string> warnings;
    const std::size_t before = peak_memory();
    std::size_t errors = 0, meshes = 0;
    for (const auto& [name, original] : originals()) {
        read_mesh(directory.write(name, original), {}, warnings);
        Generator random(14);
        for (int i = 0; i < 400; ++i) {
            const std::string text = mutated(original, random);
            // If a signal ends the test, the input stays in `directory`; other failures tell its number.
            SCOPED_TRACE(name + " " + std::to_string(i));
            const auto file = directory.write(name, text);
            try {
                const Mesh mesh = read_mesh(
                    file, {.join_duplicate_points = i % 3 == 0, .repair = Repair{i % 2 == 0 ? 2 : i % 4 / 2}},
                    warnings);
                EXPECT_TRUE(mesh.is_valid(false));
                EXPECT_GT(mesh.number_of_faces(), 0u);
                ++meshes;
            } catch (const Error& error) {
                EXPECT_EQ(error.fault, Fault::input) << error.what();
                EXPECT_NE(std::string(error.what()).find(name), std::string::npos) << error.what();
                ++errors;
            }
        }
    }
    EXPECT_GT(errors, 1000u) << "the mutations do no harm: the test tests nothing";
    EXPECT_GT(meshes, 100u) << "the mutations leave nothing to read behind a header";
    EXPECT_LT(peak_memory() - before, 256u << 20) << "a count in a file was believed";
}

}  // namespace
}  // namespace sherd::test
