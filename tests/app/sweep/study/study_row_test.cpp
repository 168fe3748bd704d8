// SPDX-License-Identifier: GPL-3.0-or-later
// Rows of a study, and their identities: a hash of too little would give a row the result of another scene,
// and a hash of too much would run everything again.
#include "app/sweep/study/study_row.h"

#include <gtest/gtest.h>

#include "meshops/error.h"
#include "tests/support/program/falling_disc.h"
#include "tests/support/program/temporary_directory.h"

namespace sherd::test {
namespace {

struct StudyFolder {
    StudyFolder() { directory.write("disc.toml", falling_disc); }

    StudyRows rows(const std::string& text) const {
        return study_rows(parse_study("scene = \"disc.toml\"\n" + text, directory.path / "study.toml", false),
                          true);
    }
    std::string mistake(const std::string& text) const {
        try {
            rows(text);
        } catch (const Error& error) {
            return error.what();
        }
        return "";
    }

    TemporaryDirectory directory;
};

TEST(StudyRows, RepeatsHaveSeedsThatFollowEachOther) {
    const StudyFolder folder;
    const StudyRows all = folder.rows("repeats = 3\n[parameters]\nsolver.step = [1e-3, 5e-4]\n");
    ASSERT_EQ(all.rows.size(), 6u);
    for (std::size_t i = 0; i < 6; ++i) {
        EXPECT_EQ(all.rows[i].seed, static_cast<std::int64_t>(1 + i % 3));
        EXPECT_EQ(all.rows[i].point, i / 3);
    }
}

TEST(StudyRows, CommandsRepeatThem) {
    const StudyFolder folder;
    const StudyRows all = folder.rows(
        "[parameters]\nspeed = { set = \"sheet.plate.velocity=[0, 0, -{}]\", values = [2] }\n"
        "solver.scheme = [\"bdf2\"]\n");
    EXPECT_EQ(row_command(all, all.rows[0]),
              "sherd run " + (folder.directory.path / "disc.toml").string() +
                  " --set 'sheet.plate.velocity=[0, 0, -2]' --set 'solver.scheme=\"bdf2\"'");
    EXPECT_EQ(all.rows[0].values, (std::vector<std::string>{"2", "bdf2"}));
}

TEST(StudyRows, TheSameSceneIsTheSameRowInAnotherStudy) {
    const StudyFolder folder;
    const StudyRows one = folder.rows("[parameters]\nsolver.step = [1e-3, 5e-4]\n");
    const StudyRows other = folder.rows(
        "measures = [\"fragments\"]\n[parameters]\nstep = { set = \"solver.step={}\", values = [2e-3, 5e-4] "
        "}\n");
    EXPECT_EQ(one.rows[1].identity, other.rows[1].identity);
    EXPECT_NE(one.rows[0].identity, other.rows[0].identity);
    folder.directory.write("disc.toml", "# another comment\n" + falling_disc);
    EXPECT_EQ(one.rows[1].identity,
              folder.rows("[parameters]\nsolver.step = [1e-3, 5e-4]\n").rows[1].identity);
    EXPECT_NE(one.rows[1].identity,
              folder.rows("over = 1e-3\n[parameters]\nsolver.step = [1e-3, 5e-4]\n").rows[1].identity)
        << "other fragments count";
}

TEST(StudyRows, AMeshThatChangesIsAnotherRow) {
    const StudyFolder folder;
    const std::string square = "v 0 0 0\nv 0.1 0 0\nv 0.1 0.1 0\nv 0 0.1 0\nf 1 2 3\nf 1 3 4\n";
    folder.directory.write("square.obj", square);
    const std::string text = "[parameters]\nsheet.plate.mesh = [\"square.obj\"]\n";
    const StudyRows before = folder.rows(text);
    folder.directory.write("square.obj", square + "# painted\n");
    const StudyRows after = folder.rows(text);
    EXPECT_EQ(before.rows[0].scene, after.rows[0].scene);
    EXPECT_NE(before.rows[0].files, after.rows[0].files);
    EXPECT_NE(before.rows[0].identity, after.rows[0].identity);
}

TEST(StudyRows, AMeasuringFileThatChangesIsAnotherRow) {
    const StudyFolder folder;
    folder.directory.write("m.py", "def measure(recording): return {}\n");
    const std::uint64_t before = folder.rows("python = \"m.py\"\n").rows[0].identity;
    folder.directory.write("m.py", "def measure(recording): return {'a': 1}\n");
    EXPECT_NE(folder.rows("python = \"m.py\"\n").rows[0].identity, before);
}

TEST(StudyRows, ScenesThatWouldBeRefusedAreRefusedBeforeAnythingRuns) {
    const StudyFolder folder;
    EXPECT_NE(folder.mistake("[parameters]\nsolver.stap = [1e-3]\n").find("did you mean 'step'?"),
              std::string::npos);
    EXPECT_NE(
        folder.mistake("[parameters]\nsolver.step = [1e-3, -1]\n").find("solver.step: must be a positive"),
        std::string::npos);
    EXPECT_NE(folder.mistake("[parameters]\nsheet.plate.mesh = [\"none.obj\"]\n").find("none.obj"),
              std::string::npos)
        << "the last value names a mesh that is not there";
    EXPECT_NE(folder.mistake("variant = \"thin\"\n").find("--variant thin"), std::string::npos);
    EXPECT_NE(folder.mistake("python = \"none.py\"\n").find("none.py"), std::string::npos);
}

TEST(StudyRows, MeasuresOfSupportsThatNoRowHasAreRefused) {
    const StudyFolder folder;
    folder.directory.write(
        "disc.toml", falling_disc + "[obstacle.floor]\nplane = { point = [0, 0, -1], normal = [0, 0, 1] }\n");
    EXPECT_EQ(folder.mistake("measures = [\"peak_force.floor\", \"peak_force_time.floor\"]\n"), "");
    const std::string mistake = folder.mistake("measures = [\"peak_force.flour\"]\n");
    EXPECT_NE(mistake.find(
                  "study.toml: measures: peak_force.flour: the scene has no support or obstacle 'flour'; did "
                  "you mean 'floor'? there are: floor"),
              std::string::npos)
        << mistake;
}

TEST(StudyRows, OfAVariantOneIsNamedOrVaried) {
    const StudyFolder folder;
    folder.directory.write("disc.toml", falling_disc +
                                            "[[variant]]\nname = \"slow\"\n[[variant]]\nname = \"fast\"\n"
                                            "sheet.plate.velocity = [0, 0, -5]\n");
    EXPECT_NE(folder.mistake("").find("has variants"), std::string::npos);
    const StudyRows all = folder.rows("[parameters]\nvariant = [\"slow\", \"fast\"]\n");
    ASSERT_EQ(all.rows.size(), 2u);
    EXPECT_NE(all.rows[0].scene, all.rows[1].scene);
    EXPECT_NE(row_command(all, all.rows[1]).find("--variant fast"), std::string::npos);
}

}  // namespace
}  // namespace sherd::test
