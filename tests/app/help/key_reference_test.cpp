// SPDX-License-Identifier: GPL-3.0-or-later
// The reference, completion of --set and the tables of the pages come from the declared keys. If this failed,
// a user would not find a key, or would read another default than the reader has.
#include "app/help/key_reference.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

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
