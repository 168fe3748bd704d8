// SPDX-License-Identifier: GPL-3.0-or-later
// The reference, completion of --set and the tables of the pages come from the declared keys. If this failed,
// a user would not find a key, or would read another default than the reader has.
#include "app/help/key_reference.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

#include "app/scene/read/sheet/material_presets.h"
#include "meshops/error.h"
#include "tests/support/program/contains.h"
#include "tests/support/program/message_thrown_by.h"

namespace sherd::test {
namespace {

TEST(KeyReference, ATableHasAllItsKeysWithValueDefaultAndMeaning) {
    const std::string text = key_reference("solver", 0);
    EXPECT_TRUE(contains(text, "[solver] Time steps and their solution\n")) << text;
    EXPECT_TRUE(contains(
        text, "  max_stages      an integer of 1 or more; default: 100. largest number of stages in a step"))
        << text;
    EXPECT_TRUE(contains(text, "\"implicit-euler\", \"bdf2\", \"auto\", \"explicit\" or \"static\"")) << text;
    EXPECT_FALSE(contains(text, "adaptive")) << "a retired key is no advice: " << text;
    EXPECT_FALSE(contains(text, "[solver.damping]")) << "of this table alone: " << text;
}

TEST(KeyReference, AKeyIsFoundByItsNameInAllTablesThatHaveIt) {
    const std::string friction = key_reference("friction", 0);
    for (const char* place : {"[contact]", "[obstacle.NAME]", "[force.wind]"})
        EXPECT_TRUE(contains(friction, place)) << friction;
    EXPECT_FALSE(contains(friction, "young")) << friction;
    const std::string one = key_reference("contact.friction", 0);
    EXPECT_TRUE(contains(one, "[contact]")) << one;
    EXPECT_FALSE(contains(one, "[obstacle.NAME]")) << one;
}

TEST(KeyReference, SheetsAndObstaclesNeedNoName) {
    EXPECT_EQ(key_reference("sheet.fracture", 0), key_reference("sheet.NAME.fracture", 0));
    EXPECT_EQ(key_reference("fracture", 0), key_reference("sheet.NAME.fracture", 0));
    EXPECT_TRUE(contains(key_reference("scene", 0), "  seed ")) << key_reference("scene", 0);
}

// A user copies a name from a scene, from --set, or from a heading that the reference itself prints.
TEST(KeyReference, NamesMayBeWrittenAsInScenesAndHeadings) {
    EXPECT_EQ(key_reference("sheet.plate.fracture", 0), key_reference("sheet.fracture", 0));
    EXPECT_EQ(key_reference("obstacle.floor.friction", 0), key_reference("obstacle.friction", 0));
    EXPECT_EQ(key_reference("[solver]", 0), key_reference("solver", 0));
    EXPECT_EQ(key_reference("[sheet.NAME.material]", 0), key_reference("sheet.material", 0));
    EXPECT_EQ(key_reference("[[gauge]]", 0), key_reference("gauge", 0));
    EXPECT_TRUE(contains(test::message_thrown_by([] { key_reference("sheet.plate.fractur", 0); }),
                         "--keys sheet.plate.fractur: scenes have no table and no key of this name; did you "
                         "mean 'sheet.fracture'?"));
}

// The name nearest to a key of earlier versions would be wrong advice.
TEST(KeyReference, ARetiredNameIsAnErrorWithItsReplacement) {
    for (const char* name : {"solver.adaptive", "[solver.adaptive]"})
        EXPECT_TRUE(
            contains(test::message_thrown_by([&] { key_reference(name, 0); }),
                     "--keys solver.adaptive: is no key any more: scheme = \"auto\" makes short steps"));
    EXPECT_TRUE(contains(test::message_thrown_by([] { key_reference("solver.midpoint", 0); }),
                         "scheme has no \"midpoint\" any more: \"bdf2\""));
}

TEST(KeyReference, ValuesAreThoseThatTheReaderAccepts) {
    const auto says = [](const std::string& key, const std::string& wanted) {
        EXPECT_TRUE(contains(key_reference(key, 0), wanted)) << key_reference(key, 0);
    };
    for (const MaterialPreset& preset : material_presets())
        says("sheet.material.preset", fmt::format("\"{}\"", preset.name));
    says("force.load.box", "an array of 2 arrays of 3 numbers (m)");
    says("obstacle.young", "default: 3e10");
    says("variant", "the name of the variant in quotes; required");
    says("force.load.pressure", "without a selection the load acts on the whole sheet");
    const std::string structured = key_reference("sheet.mesh.structured", 0);
    EXPECT_FALSE(contains(structured, "disc")) << structured;
    EXPECT_TRUE(contains(structured, "rectangle")) << structured;
}

TEST(KeyReference, AnUnknownNameIsAnErrorWithTheNearestOne) {
    EXPECT_TRUE(
        contains(test::message_thrown_by([] { key_reference("solvr", 0); }), "did you mean 'solver'?"));
    EXPECT_TRUE(contains(test::message_thrown_by([] { key_reference("solver.stpe", 0); }),
                         "did you mean 'solver.step'?"));
}

TEST(KeyReference, LinesFitTheTerminal) {
    std::istringstream lines(key_reference("", 100));
    int count = 0;
    for (std::string line; std::getline(lines, line); ++count) {
        std::size_t characters = std::ranges::count_if(line, [](char c) { return (c & 0xc0) != 0x80; });
        EXPECT_LE(characters, 100u) << line;
    }
    EXPECT_GT(count, 200);
}

TEST(KeyReference, TablesOfMarkdownHaveFourCellsARow) {
    std::istringstream lines(key_tables(""));
    int rows = 0;
    for (std::string line; std::getline(lines, line);) {
        if (!line.starts_with("|")) continue;
        ++rows;
        std::size_t cells = 0;
        for (std::size_t at = 1; at < line.size(); ++at) cells += line[at] == '|' && line[at - 1] != '\\';
        EXPECT_EQ(cells, 4u) << line;
    }
    EXPECT_GT(rows, 150);
}

TEST(KeyReference, SettableKeysHaveTheNamesOfTheSceneAndTheirWords) {
    const std::vector<std::string> lines = settable_lines({"cup", "saucer"}, {"floor"});
    const auto offers = [&](const std::string& line) {
        return std::ranges::find(lines, line) != lines.end();
    };
    EXPECT_TRUE(offers("solver.step"));
    EXPECT_TRUE(offers("solver.method quasi-newton newton"));
    EXPECT_TRUE(offers("solver.arc_length true false"));
    EXPECT_TRUE(offers("sheet.cup.material.young"));
    EXPECT_TRUE(offers("sheet.saucer.fracture.weibull"));
    EXPECT_TRUE(offers("obstacle.floor.friction"));
    EXPECT_TRUE(std::ranges::any_of(lines, [](const std::string& line) {
        return line.starts_with("sheet.cup.material.preset stoneware porcelain ");
    }));
    for (const char* variant : {"variant", "variant.name"})
        EXPECT_FALSE(offers(variant)) << "--set cannot add a variant";
    EXPECT_FALSE(offers("sheet.cup")) << "a table has no value of its own";
    EXPECT_TRUE(
        offers("sheet.cup.mesh.generate rectangle disc cylinder sphere plate bowl revolution polygon"));
    std::vector<std::string> keys;
    for (const std::string& line : lines) keys.push_back(line.substr(0, line.find(' ')));
    for (const std::string& key : keys) EXPECT_FALSE(contains(key, "NAME")) << key;
    EXPECT_TRUE(std::ranges::adjacent_find(keys) == keys.end()) << "a key is offered twice";
}

}  // namespace
}  // namespace sherd::test
