// SPDX-License-Identifier: GPL-3.0-or-later
// Table of crack tips: if rows of several tips were mixed, a reader would take one crack's speed for
// another's.
#include "app/commands/info/tip_info.h"

#include <gtest/gtest.h>

namespace sherd {
namespace {

TipRecord record(Index tip, double time, double speed, double released) {
    TipRecord one;
    one.tip = tip;
    one.time = time;
    one.speed = speed;
    one.released = released;
    one.toughness = 8;
    one.opening = 1e5 * time;
    return one;
}

TEST(TipInfo, TellsEachTipFromItsFirstRowToItsLast) {
    const std::vector<TipRecord> rows{record(3, 1, 100, 9), record(0, 1, 0, 4), record(3, 2, 700, 16),
                                      record(3, 3, 500, 12)};
    const std::vector<TipInfo> tips = tips_of(rows);
    ASSERT_EQ(tips.size(), 2u);
    EXPECT_EQ(tips[0].last.tip, 0);
    EXPECT_EQ(tips[1].first.time, 1);
    EXPECT_EQ(tips[1].last.time, 3);
    EXPECT_EQ(tips[1].fastest, 700);
    EXPECT_EQ(tips[1].largest, 16);
    const Json json = tips_json(tips);
    EXPECT_EQ(json.dump(), tips_json(tips).dump());
    EXPECT_NE(json.dump().find("\"largest_G\""), std::string::npos);
}

TEST(TipInfo, ListsThoseThatBoreMostOfMany) {
    std::string none;
    add_tip_table(none, {}, "s");
    EXPECT_EQ(none, "");
    std::vector<TipRecord> rows;
    for (Index tip = 0; tip < 25; ++tip) rows.push_back(record(tip, 1, 0, 1 + tip));
    std::string text;
    add_tip_table(text, tips_of(rows), "s");
    EXPECT_EQ(text.find("\n4  "), std::string::npos);
    EXPECT_NE(text.find("\n5  "), std::string::npos);
    EXPECT_NE(text.find("\n24 "), std::string::npos);
    EXPECT_NE(text.find("5 tips with a smaller largest G"), std::string::npos);
}

}  // namespace
}  // namespace sherd
