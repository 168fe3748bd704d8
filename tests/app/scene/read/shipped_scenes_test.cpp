// SPDX-License-Identifier: GPL-3.0-or-later
// Shipped scenes by name: if a test failed, a newcomer would not find them, or would run a wrong one.
#include "app/scene/read/shipped_scenes.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "app/files/disk/checksum.h"
#include "app/scene/read/scene.h"
#include "tests/support/program/message_thrown_by.h"
#include "tests/support/program/program.h"
#include "tests/support/program/temporary_directory.h"

namespace sherd::test {
namespace {

namespace fs = std::filesystem;

const fs::path scenes = fs::canonical(SHERD_SCENES);

std::string without_suffix(const std::string& name) {
    return name.substr(0, name.size() - std::string(".toml").size());
}

TEST(SceneText, AMeshOrARecordingInPlaceOfAFileIsNamedAsSuch) {
    const TemporaryDirectory directory;
    for (const auto& [name, content, reason] :
         {std::tuple("bowl.obj", "v 0 0 0\n",
                     "bowl.obj: cannot read the scene: it is a mesh, which a scene names"),
          {"bowl.h5", "\x89HDF\r\n\x1a\n",
           "bowl.h5: cannot read the scene: it is an HDF5 file, as recordings are"}}) {
        const std::filesystem::path file = directory.write(name, content);
        const std::string said = message_thrown_by([&] { read_scene_text(file); });
        EXPECT_NE(said.find(reason), std::string::npos) << said;
    }
}

TEST(ShippedScenes, AreListedOneALineWithWhatTheirFilesSay) {
    const TemporaryDirectory directory;
    const ProgramResult result = run_sherd({"scenes"}, directory.path);
    ASSERT_EQ(result.exit_code, 0) << result.err;
    std::set<std::string> listed, there;
    std::istringstream lines(result.out);
    for (std::string line; std::getline(lines, line);) {
        listed.insert(line.substr(0, line.find(' ')));
        EXPECT_GT(line.size(), line.find_first_not_of(' ', line.find(' ')) + 20)
            << "no description: " << line;
    }
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(scenes))
        if (entry.path().extension() == ".toml" && entry.path().parent_path().filename() != "studies")
            there.insert(without_suffix(entry.path().lexically_relative(scenes).string()));
    EXPECT_EQ(listed, there);
    EXPECT_NE(
        result.out.find(" A stoneware dinner plate falls 80 cm onto a wooden floor, tilted by 30 degrees, so "
                        "that its rim strikes first\n"),
        std::string::npos)
        << result.out;
    EXPECT_LT(result.out.find("\nwindow_ball"), result.out.find("\npaper/")) << "the paper's come last";
}

TEST(ShippedScenes, JsonNamesFilesThatAreThere) {
    const TemporaryDirectory directory;
    const ProgramResult result = run_sherd({"scenes", "--json"}, directory.path);
    ASSERT_EQ(result.exit_code, 0) << result.err;
    const nlohmann::json list = nlohmann::json::parse(result.out);
    ASSERT_GT(list.size(), 10u);
    for (const nlohmann::json& scene : list) EXPECT_TRUE(fs::is_regular_file(scene["file"].get<fs::path>()));
}

TEST(ShippedScenes, AreFoundByNameWhereNoFileIsMeant) {
    const TemporaryDirectory directory;
    for (const std::string name : {"plate_drop", "plate_drop.toml", "paper/figure_6_plates"}) {
        const ProgramResult result = run_sherd({"check", name, "--set", "duration=0.001"}, directory.path);
        EXPECT_EQ(result.exit_code, 0) << result.err;
        const std::string file = (scenes / name).replace_extension(".toml").string();
        EXPECT_NE(result.out.find(file), std::string::npos) << result.out;
    }
    // A run of all variants must give its processes the file that was found, and name recordings after the
    // scene.
    const ProgramResult run = run_sherd({"run", "paper/section_8_flag", "--set", "duration=0.002", "--set",
                                         "sheet.flag.mesh.edge_length=0.2"},
                                        directory.path);
    EXPECT_EQ(run.exit_code, 0) << run.err;
    EXPECT_TRUE(fs::exists(directory.path / "section_8_flag-6.h5")) << run.out;
}

TEST(ShippedScenes, GiveWayToAnyFileOfTheUsersOwn) {
    const TemporaryDirectory directory;
    // An empty file of this name must be read, and refused, instead of the shipped scene.
    directory.write("plate_drop.toml", "");
    ProgramResult result = run_sherd({"check", "plate_drop"}, directory.path);
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_TRUE(result.err.starts_with("sherd: error: plate_drop.toml:1:")) << result.err;
    directory.write("plate_drop", "?");
    result = run_sherd({"check", "plate_drop"}, directory.path);
    EXPECT_TRUE(result.err.starts_with("sherd: error: plate_drop:1:")) << result.err;
}

TEST(ShippedScenes, AFolderOfTheSameNameIsNotInTheWay) {
    const TemporaryDirectory directory;
    fs::create_directory(directory.path / "plate_drop");
    const ProgramResult result = run_sherd({"check", "plate_drop"}, directory.path);
    EXPECT_EQ(result.exit_code, 0) << result.err;
}

TEST(ShippedScenes, ANameThatIsNotThereGetsTheNearestOne) {
    const TemporaryDirectory directory;
    const auto message = [&](const std::string& name) {
        const ProgramResult result = run_sherd({"check", name}, directory.path);
        EXPECT_EQ(result.exit_code, 2);
        EXPECT_TRUE(result.err.starts_with("sherd: error: " + name + ": cannot read the scene: there is no "))
            << result.err;
        EXPECT_NE(result.err.find("'sherd scenes' lists"), std::string::npos) << result.err;
        return result.err;
    };
    EXPECT_NE(message("plate_dorp").find("did you mean 'plate_drop'?"), std::string::npos);
    EXPECT_NE(message("figure_6_plates").find("did you mean 'paper/figure_6_plates'?"), std::string::npos);
    EXPECT_NE(message("scenes/plate_drop.toml").find("did you mean 'plate_drop'?"), std::string::npos);
    EXPECT_EQ(message("zzzzzzzzz").find("did you mean"), std::string::npos);
}

TEST(ShippedScenes, ACopyRunsWithTheFilesThatItNames) {
    const TemporaryDirectory directory;
    ProgramResult result = run_sherd({"scenes", "--copy", "bowl_on_anvil", "-o", "mine"}, directory.path);
    ASSERT_EQ(result.exit_code, 0) << result.err;
    EXPECT_EQ(result.out, "mine/bowl_on_anvil.toml\nmine/anvil.obj\n");
    for (const std::string name : {"bowl_on_anvil.toml", "anvil.obj"})
        EXPECT_EQ(text_of(directory.path / "mine" / name), text_of(scenes / name));
    result = run_sherd({"check", "mine/bowl_on_anvil"}, directory.path);
    EXPECT_EQ(result.exit_code, 0) << result.err;
}

TEST(ShippedScenes, ACopyKeepsWhatIsThere) {
    const TemporaryDirectory directory;
    directory.write("anvil.obj", "mine");
    ProgramResult result = run_sherd({"scenes", "--copy", "bowl_on_anvil"}, directory.path);
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_NE(result.err.find("anvil.obj"), std::string::npos) << result.err;
    EXPECT_EQ(text_of(directory.path / "anvil.obj"), "mine");
    EXPECT_FALSE(fs::exists(directory.path / "bowl_on_anvil.toml")) << "half a copy";
    result = run_sherd({"scenes", "--copy", "bowl_on_anvil", "--force"}, directory.path);
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_EQ(text_of(directory.path / "anvil.obj"), text_of(scenes / "anvil.obj"));
    result = run_sherd({"scenes", "--copy", "bowl_on_anvli"}, directory.path);
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_NE(result.err.find("did you mean 'bowl_on_anvil'?"), std::string::npos) << result.err;
}

TEST(ShippedScenes, DescriptionsAreTheFirstSentence) {
    const TemporaryDirectory directory;
    fs::create_directory(directory.path / "a");
    directory.write("a/z.toml", "# Two lines, of 0.5 m\n# each. Look at: nothing.\nduration = 1\n");
    directory.write("b.toml", "# SPDX-License-Identifier: MIT\n# No full stop\n# Still.\n");
    directory.write("c.toml", "duration = 1\n# not this\n");
    const std::vector<ShippedScene> found = shipped_scenes(directory.path);
    ASSERT_EQ(found.size(), 3u);
    EXPECT_EQ(found[0].name, "b");
    EXPECT_EQ(found[0].description, "No full stop Still");
    EXPECT_EQ(found[1].description, "");
    EXPECT_EQ(found[2].name, "a/z");
    EXPECT_EQ(found[2].description, "Two lines, of 0.5 m each");
}

}  // namespace
}  // namespace sherd::test
