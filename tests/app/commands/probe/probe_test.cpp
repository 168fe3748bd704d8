// SPDX-License-Identifier: GPL-3.0-or-later
// `sherd probe` through the real program. probe_reference.py verifies its numbers. Here the numbers must
// belong to the given meshes, vertices and materials, and meshes or materials that do not fit are refused.
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "app/recording/hdf5.h"
#include "app/recording/hdf5_file.h"
#include "tests/support/program/program.h"
#include "tests/support/program/replaced.h"
#include "tests/support/program/temporary_directory.h"

namespace sherd::test {
namespace {

const std::string material = "density = 1000\nthickness = 0.01\nyoung = 1e6\npoisson = 0.25\n";
// A fold between two triangles; vertices 2 and 5 belong to no face.
const std::string fold = R"(v 0 0 0
v 1 0 0
v 7 7 7
v 0.3 1 0
v 0.6 -0.5 0.4
v 8 8 8
f 1 2 4
f 1 5 2
)";

/// Test with the files rest.obj, deformed.obj and material.toml in a folder of its own.
struct ProbeTest : testing::Test {
    ProbeTest() {
        directory.write("rest.obj", fold);
        directory.write("deformed.obj", replaced(fold, "v 0.6 -0.5 0.4", "v 0.6 -0.4 0.6"));
        directory.write("material.toml", material);
    }
    ProgramResult run(std::vector<std::string> more = {}) const {
        more.insert(more.begin(), {"probe", "rest.obj", "deformed.obj", "--material", "material.toml"});
        return run_sherd(more, directory.path);
    }
    nlohmann::json json() const {
        const ProgramResult result = run({"--json"});
        EXPECT_EQ(result.exit_code, 0) << result.err;
        return nlohmann::json::parse(result.out);
    }
    void expect_error(const std::vector<std::string>& message, std::vector<std::string> more = {}) const {
        const auto before = directory.contents();
        if (more.empty()) more = {"-o", "probe.h5"};
        const ProgramResult result = run(more);
        EXPECT_EQ(result.exit_code, 2) << result.out << result.err;
        EXPECT_EQ(result.out, "");
        EXPECT_NE(result.err.find("sherd: error: "), std::string::npos) << result.err;
        for (const std::string& part : message)
            EXPECT_NE(result.err.find(part), std::string::npos) << result.err;
        EXPECT_TRUE(directory.contents() == before) << "something was written";
    }
    TemporaryDirectory directory;
};

TEST_F(ProbeTest, NumbersOfTheFileWithZeroForceWhereNoFaceIs) {
    const nlohmann::json probed = json();
    EXPECT_EQ(probed["vertices"], 6);
    EXPECT_EQ(probed["faces"], 2);
    EXPECT_EQ(probed["hinges"], 1);
    const auto hinge = probed["largest_strain"]["bending"]["vertices"].get<std::array<Index, 4>>();
    EXPECT_TRUE((hinge == std::array<Index, 4>{0, 1, 3, 4} || hinge == std::array<Index, 4>{1, 0, 4, 3}));
    ASSERT_EQ(run({"-o", "probe.h5"}).exit_code, 0);
    const hdf5::ReadableFile file(directory.path / "probe.h5");
    EXPECT_EQ((hdf5::read<std::array<Index, 4>>(file, "hinge/vertices").at(0)), hinge);
    for (const auto& [name, energy] : probed["energy"].items()) {
        const std::vector<Vector3d> force = hdf5::read<Vector3d>(file, "force/" + name);
        ASSERT_EQ(force.size(), 6u);
        EXPECT_EQ(force[2].norm() + force[5].norm(), 0);
        Vector3d sum = Vector3d::Zero();
        double square = 0;
        for (const Vector3d& f : force) {
            sum += f;
            square += f.squaredNorm();
        }
        EXPECT_GT(square, 0) << name;
        EXPECT_LT(sum.norm(), 1e-12 * std::sqrt(square)) << name;
        EXPECT_NEAR(std::sqrt(square) / probed["force_norm"][name].get<double>(), 1, 1e-14) << name;
    }
}

// The fold bends towards the faces' normals, so that the top surfaces of the faces are compressed.
TEST_F(ProbeTest, StressIsLargestWhereTheFoldIsStretched) {
    directory.write("rest.obj", replaced(fold, "v 0.6 -0.5 0.4", "v 0.6 -0.5 0"));
    directory.write("deformed.obj", replaced(fold, "v 0.6 -0.5 0.4", "v 0.6 -0.49999 0.003"));
    const nlohmann::json probed = json();
    EXPECT_GT(probed["largest_curvature"]["curvature"].get<double>(), 0);
    EXPECT_EQ(probed["largest_stress"]["surface"], "bottom");
    EXPECT_EQ(probed["largest_stress"]["vertices"].size(), 3u);
    const ProgramResult table = run();
    EXPECT_NE(table.out.find("at the bottom"), std::string::npos) << table.out;
}

TEST_F(ProbeTest, RestShapeHasNoEnergyAndOnlyThePapersCubicHingeAForce) {
    directory.write("deformed.obj", fold);
    const nlohmann::json at_rest = json();
    const double stiffness = 1e6 * 1e-6 / (12 * (1 - 0.25 * 0.25)) / 3;
    for (const auto& [name, energy] : at_rest["energy"].items())
        EXPECT_LT(std::abs(energy.get<double>()), 1e-13 * stiffness) << name;
    for (const auto& [name, norm] : at_rest["force_norm"].items()) {
        const double scale = name.starts_with("membrane") ? 1e6 * 0.01 : stiffness;
        if (name == "bending_cubic_2007")
            EXPECT_GT(norm.get<double>(), 0.1 * scale);
        else
            EXPECT_LT(norm.get<double>(), 1e-14 * scale) << name;
    }
}

TEST_F(ProbeTest, BendingStiffnessIsThatOfEveryHingeAndOfNothingElse) {
    const nlohmann::json before = json();
    directory.write("material.toml", material + "bending_stiffness = 3\n");
    const nlohmann::json three = json();
    directory.write("material.toml", material + "bending_stiffness = 6\n");
    const nlohmann::json six = json();
    EXPECT_EQ(before["energy"]["membrane"], six["energy"]["membrane"]);
    EXPECT_EQ(before["energy"]["membrane_arc"], six["energy"]["membrane_arc"]);
    for (const auto& [name, energy] : six["energy"].items())
        if (!name.starts_with("membrane")) {
            EXPECT_NEAR(energy.get<double>() / three["energy"][name].get<double>(), 2, 1e-12);
        }
}

TEST_F(ProbeTest, TableForPeopleSaysTheSame) {
    const ProgramResult result = run();
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_NE(result.err.find("2 vertices were dropped that no face uses"), std::string::npos) << result.err;
    const nlohmann::json probed = json();
    for (const auto& [name, energy] : probed["energy"].items())
        EXPECT_NE(result.out.find("\n" + name + " "), std::string::npos) << result.out;
    EXPECT_NE(result.out.find("bending strain"), std::string::npos) << result.out;
}

TEST_F(ProbeTest, SheetOfOneTriangleHasNoHinge) {
    const std::string triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
    directory.write("rest.obj", triangle);
    directory.write("deformed.obj", replaced(triangle, "v 1 0 0", "v 2 0 0"));
    const nlohmann::json probed = json();
    EXPECT_TRUE(probed["largest_strain"]["bending"].is_null());
    EXPECT_NEAR(probed["largest_strain"]["membrane"]["strain"].get<double>(), 1.5, 1e-14);
    const double stress = 1.5 * 1e6 / (1 - 0.25 * 0.25);
    EXPECT_NEAR(probed["largest_stress"]["stress"].get<double>(), stress, 1e-8 * stress);
    EXPECT_EQ(probed["largest_curvature"]["curvature"], 0);
    EXPECT_EQ(run({"-o", "probe.h5"}).exit_code, 0);
    const hdf5::ReadableFile file(directory.path / "probe.h5");
    const std::vector<Vector3d> bottom = hdf5::read<Vector3d>(file, "face/stress_bottom");
    ASSERT_EQ(bottom.size(), 1u);
    EXPECT_NEAR(bottom[0].head<2>().maxCoeff(), stress, 1e-8 * stress);
    EXPECT_TRUE(hdf5::read<double>(file, "hinge/angle").empty());
}

TEST_F(ProbeTest, OtherFacesAreRefusedByTheFirstThatDiffers) {
    directory.write("deformed.obj", replaced(fold, "f 1 5 2", "f 1 5 3"));
    expect_error({"deformed.obj:8: face 1:", "(0, 4, 1) in 'rest.obj'", "(0, 4, 2) in 'deformed.obj'"});
    directory.write("deformed.obj", replaced(fold, "f 1 5 2\n", ""));
    expect_error({"deformed.obj: ", "face 1 is (0, 4, 1) in 'rest.obj'", "not there in 'deformed.obj'"});
    directory.write("deformed.obj", fold + "f 1 2 3\n");
    expect_error({"deformed.obj:9: face 2:", "not there in 'rest.obj'"});
}

TEST_F(ProbeTest, MeshesThatCannotBeRead) {
    directory.write("deformed.obj", replaced(fold, "v 0.3 1 0", "v 0.3 1 nan"));
    expect_error({"deformed.obj:4: vertex 3", "NaN"});
    directory.write("deformed.obj", fold);
    directory.write("rest.obj", replaced(fold, "v 0.3 1 0", "v 0.3 0 0"));
    expect_error({"rest.obj:7: face 0", "zero area"});
    std::filesystem::remove(directory.path / "rest.obj");
    expect_error({"rest.obj"});
}

TEST_F(ProbeTest, CollapsedTriangleIsNamedInsteadOfGivenNoNumbers) {
    directory.write("deformed.obj", replaced(fold, "v 0.3 1 0", "v 0.3 0 0"));
    expect_error({"bending_nonlinear", "0, 1, 3, 4", "collapsed"});
}

TEST_F(ProbeTest, MaterialsThatCannotBeUsed) {
    const auto expect = [this](const std::string& text, const std::vector<std::string>& message) {
        directory.write("material.toml", text);
        expect_error(message);
    };
    expect("density = 1\nyoung = 1\n",
           {"material.toml:1: thickness: is missing: give a positive number (m)"});
    expect(material + "yuong = 3\n", {"material.toml:5: yuong: unknown key; did you mean 'young'?"});
    expect(material + "bending_stifness = 3\n", {"material.toml:5:", "did you mean 'bending_stiffness'?"});
    expect(material + "bending_stiffness = -3\n",
           {"material.toml:5: bending_stiffness: must be a positive number (N m), not -3"});
    expect(material + "[material]\n", {"material.toml:5: material: unknown key"});
    const std::string wood = "density = 500\nthickness = 0.01\nyoung = [4e6, 1e6]\nshear = 1e6\n";
    expect(wood + "poisson = 2.5\n", {"material.toml:5: poisson: is inadmissible", "Y01^2 < Y0 Y1 fails"});
    expect(wood + "axis = { texture = \"none.png\" }\n", {"material.toml:5: axis.texture: ", "none.png"});
    expect("young = ", {"material.toml:1:", "TOML syntax"});
    std::filesystem::remove(directory.path / "material.toml");
    expect_error({"material.toml: cannot read the material"});
}

TEST_F(ProbeTest, OutputThatExistsIsKeptUnlessForced) {
    directory.write("probe.h5", "precious");
    expect_error({"'probe.h5' exists", "--force"});
    EXPECT_EQ(run({"-o", "probe.h5", "--force"}).exit_code, 0);
    EXPECT_TRUE(hdf5::contains(hdf5::ReadableFile(directory.path / "probe.h5"), "force/membrane"));
    expect_error({"cannot create 'nowhere/probe.h5'"}, {"-o", "nowhere/probe.h5"});
}

}  // namespace
}  // namespace sherd::test
