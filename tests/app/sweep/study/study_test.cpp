// SPDX-License-Identifier: GPL-3.0-or-later
// Study files: a wrong file must be refused with the line of the mistake before anything runs.
#include "app/sweep/study/study.h"

#include <gtest/gtest.h>

#include "meshops/error.h"

namespace sherd::test {
namespace {

Study read(const std::string& text, bool quick = false) {
    return parse_study("scene = \"plate\"\n" + text, "a.toml", quick);
}

std::string mistakes(const std::string& text) {
    try {
        read(text);
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

void expect_mistake(const std::string& text, const std::string& words) {
    EXPECT_NE(mistakes(text).find(words), std::string::npos) << text << "\n" << mistakes(text);
}

using Values = std::vector<std::string>;

TEST(Study, ParametersAreKeysOfTheSceneInTheOrderOfTheFile) {
    const Study study = read(R"([parameters]
solver.step = [1e-4, 0.3]
sheet.plate.material.preset = ["glass", "stoneware"]
sheet.plate.velocity = [[0, 0, -1]]
)");
    ASSERT_EQ(study.parameters.size(), 3u);
    EXPECT_EQ(study.parameters[0].name, "solver.step");
    EXPECT_EQ(study.parameters[0].patterns, Values{"solver.step={}"});
    EXPECT_EQ(study.parameters[0].values, (Values{"0.0001", "0.3"}));
    EXPECT_EQ(study.parameters[1].name, "sheet.plate.material.preset");
    EXPECT_EQ(study.parameters[2].values.size(), 1u);
    EXPECT_EQ(study.design, Design::grid);
}

TEST(Study, RangesHaveBothEnds) {
    const Study study = read(R"([parameters]
a = { set = "x={}", from = 0, to = 0.3, step = 0.1 }
b = { set = ["x={}", "y=[0, {}]"], from = 1, to = 100, steps = 3, log = true }
c = { from = 2, to = 1, steps = 3 }
)");
    EXPECT_EQ(study.parameters[0].values, (Values{"0", "0.1", "0.2", "0.3"}));
    EXPECT_EQ(study.parameters[1].values, (Values{"1", "10", "100"}));
    EXPECT_EQ(study.parameters[1].patterns, (Values{"x={}", "y=[0, {}]"}));
    EXPECT_EQ(study.parameters[2].values, (Values{"2", "1.5", "1"}));
}

TEST(Study, QuickTakesItsTableOverTheOthers) {
    const std::string text =
        "repeats = 9\n[parameters]\na = [1, 2, 3]\n[quick]\nrepeats = 1\nparameters.a = [1]\n";
    EXPECT_EQ(read(text).repeats, 9);
    EXPECT_EQ(read(text).parameters[0].values.size(), 3u);
    EXPECT_EQ(read(text, true).repeats, 1);
    EXPECT_EQ(read(text, true).parameters[0].values, Values{"1"});
}

TEST(Study, MistakesAreToldWithTheirLines) {
    expect_mistake("repeat = 3\n", "a.toml:2: repeat: unknown key; did you mean 'repeats'?");
    expect_mistake("[parameters]\na = 3\n", "a.toml:3: parameters.a: is a single value");
    expect_mistake("[parameters]\na = []\n", "a.toml:3: parameters.a: is empty");
    expect_mistake("[parameters]\na = { from = 1, to = 2 }\n", "steps: is missing");
    expect_mistake("[parameters]\na = { from = 0, to = 2, steps = 3, log = true }\n", "parameters.a.from");
    expect_mistake("[parameters]\na = { set = \"x\", values = [1] }\n", "must be KEY=VALUE with {}");
    expect_mistake("[parameters]\na = { values = [1], form = 2 }\n", "parameters.a.form: unknown key");
    expect_mistake("[parameters]\na = { uniform = [1, 2] }\n", "a has a distribution");
    expect_mistake("design = \"latin\"\n", "samples: is missing");
    expect_mistake("design = \"zip\"\n[parameters]\na = [1, 2]\nb = [1]\n", "a has 2 values and b has 1");
    expect_mistake("samples = 3\n", "samples: is for design");
    expect_mistake("repeats = 2\n[parameters]\nseed = [1, 2]\n", "which is a parameter already");
    expect_mistake("[parameters]\nexit = { set = \"x={}\", values = [1] }\n",
                   "is the name of another column");
    expect_mistake("measures = [\"fragmnts\"]\n", "did you mean 'fragments'?");
    expect_mistake("keep = \"some\"\n", "a.toml:2: keep");
    EXPECT_EQ(mistakes("measures = [\"peak_force.floor\", \"mass_law.exponent\"]\n"), "");
}

TEST(Study, TooManyRowsAreRefused) {
    expect_mistake("repeats = 10000000\n[parameters]\na = [1, 2]\n", "rows, more than");
}

}  // namespace
}  // namespace sherd::test
