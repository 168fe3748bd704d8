// SPDX-License-Identifier: GPL-3.0-or-later
// The declaration of a table of keys, here of a made-up struct, is all by which it is read, refused and
// documented. If this failed, a key would be read into the wrong member, or a wrong value would be accepted.
#include "app/scene/keys/key.h"

#include <gtest/gtest.h>

#include <map>

#include "tests/support/program/message_thrown_by.h"

namespace sherd {
namespace test {

// Structs that a template argument names need a linkage of their own.
enum class Glaze { matt, clear };

struct Handle {
    double length = 0.05;
    int rivets = 2;
};

struct Mug {
    double volume = 3e-4;
    Handle handle;
    std::optional<Handle> second;
    std::vector<Handle> more;
    Glaze glaze = Glaze::clear;
    bool lid = false;
    std::optional<double> chip;
    std::string maker;
    bool is_completed = false;
};

}  // namespace test

namespace {

using test::Glaze, test::Handle, test::Mug;

constexpr std::array<std::string_view, 2> glazes{"matt", "clear"};
constexpr std::array handle_keys{
    key<&Handle::length>("length", "from end to end", {.unit = "m", .range = positive}),
    key<&Handle::rivets>("rivets", "how many hold it",
                         {.range = {.least = 1, .most = 4, .with_least = true, .with_most = true}})};
constexpr Section<Handle> handle_section{"A handle", handle_keys};

constexpr std::array own_keys{
    key<&Mug::volume>("volume", "what it holds", {.unit = "m^3", .range = positive}),
    key<&Mug::glaze>("glaze", "its surface",
                     {.choices = glazes, .retired = {"lead", "\"clear\" does no harm"}}),
    key<&Mug::lid>("lid", "whether it has one", {.excludes = {"chip"}}),
    key<&Mug::chip>("chip", "what is missing at the rim",
                    {.unit = "m", .range = not_negative, .otherwise = "none"}),
    key<&Mug::maker>("maker", "who made it", {.what = "a name", .required = true}),
    retired_key<Mug>("colour", "glaze says it"),
    table_key<handle_section, &Mug::second>("second", "another handle"),
    table_key<handle_section, &Mug::more>("more", "yet more of them")};
constexpr auto mug_keys = joined(own_keys, embedded<handle_keys, &Mug::handle>());
constexpr Section<Mug> mug_section{"A mug", mug_keys, [](TomlTable&, Mug& mug) { mug.is_completed = true; }};

Mug read_mug(const std::string& text) {
    const toml::table content = toml::parse(text);
    Problems problems;
    TomlTable table(content, "mug", problems);
    Mug mug;
    read_section(table, mug_section, mug);
    problems.throw_if_any();
    return mug;
}

TEST(Key, ValuesAreReadIntoTheirMembers) {
    const Mug mug = read_mug(
        "volume = 0.5\nglaze = \"matt\"\nlid = true\nmaker = \"Eve\"\nlength = 0.1\nrivets = 4\n"
        "second = { length = 0.2 }\nmore = [{ rivets = 1 }, { rivets = 3 }]");
    EXPECT_EQ(mug.volume, 0.5);
    EXPECT_EQ(mug.glaze, Glaze::matt);
    EXPECT_TRUE(mug.lid);
    EXPECT_EQ(mug.maker, "Eve");
    EXPECT_EQ(mug.handle.length, 0.1) << "of an embedded list";
    EXPECT_EQ(mug.handle.rivets, 4);
    ASSERT_TRUE(mug.second);
    EXPECT_EQ(mug.second->length, 0.2);
    ASSERT_EQ(mug.more.size(), 2u);
    EXPECT_EQ(mug.more[1].rivets, 3);
    EXPECT_TRUE(mug.is_completed);
}

TEST(Key, WhatIsLeftOutKeepsTheDefaultOfTheStruct) {
    const Mug mug = read_mug("maker = \"Eve\"");
    EXPECT_EQ(mug.volume, Mug{}.volume);
    EXPECT_EQ(mug.glaze, Glaze::clear);
    EXPECT_EQ(mug.handle.rivets, 2);
    EXPECT_FALSE(mug.chip);
    EXPECT_FALSE(mug.second);
    EXPECT_TRUE(mug.more.empty());
}

TEST(Key, EachMistakeIsOneErrorThatNamesItsKey) {
    for (const auto& [text, wanted] : std::vector<std::array<std::string, 2>>{
             {"volume = 0", "mug.volume"},
             {"volume = \"much\"", "mug.volume"},
             {"glaze = \"mat\"", "mug.glaze"},
             {"lid = 1", "mug.lid"},
             {"lid = true\nchip = 0.001", "mug.lid: conflicts with chip"},
             {"rivets = 0", "mug.rivets"},
             {"rivets = 5", "mug.rivets"},
             {"rivets = 1.5", "mug.rivets"},
             {"second = { lenght = 1 }", "mug.second.lenght: unknown key; did you mean 'length'?"},
             {"more = [{}, { length = -1 }]", "mug.more[1].length"},
             {"glaze = \"lead\"", "any more: \"clear\" does no harm"},
             {"colour = \"red\"", "any more: glaze says it"},
             {"volme = 1", "mug.volme: unknown key; did you mean 'volume'?"}}) {
        const std::string error =
            test::message_thrown_by([&text = text] { read_mug("maker = \"Eve\"\n" + text); });
        EXPECT_NE(error.find(wanted), std::string::npos) << text << ": " << error;
        EXPECT_EQ(error.find('\n'), std::string::npos) << "one error: " << error;
    }
    EXPECT_NE(test::message_thrown_by([] { read_mug(""); }).find("mug.maker"), std::string::npos)
        << "is required";
}

TEST(Key, TheReferenceHasDefaultsOfTheStructAndLeavesRetiredKeysOut) {
    const SectionText text = text_of(mug_section);
    std::map<std::string_view, std::string> defaults;
    for (const KeyText& key : text.keys) defaults[key.info.name] = key.fallback;
    EXPECT_EQ(defaults.size(), mug_keys.size() - 1) << "all but the retired one";
    EXPECT_EQ(defaults.at("volume"), "0.0003");
    EXPECT_EQ(defaults.at("glaze"), "\"clear\"");
    EXPECT_EQ(defaults.at("lid"), "false");
    EXPECT_EQ(defaults.at("chip"), "") << "none that is a value";
    EXPECT_EQ(defaults.at("rivets"), "2") << "of the member at the end of the path";
    for (const KeyText& key : text.keys)
        EXPECT_EQ(key.inside.size(), key.info.name == "second" || key.info.name == "more" ? 1u : 0u);
}

}  // namespace
}  // namespace sherd
