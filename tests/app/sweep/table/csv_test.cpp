// SPDX-License-Identifier: GPL-3.0-or-later
// Spreadsheets and this program read tables of studies: no cell may change.
#include "app/sweep/table/csv.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "meshops/error.h"

namespace sherd::test {
namespace {

RC_GTEST_PROP(Csv, WhatIsWrittenIsReadBack, ()) {
    const auto cell = rc::gen::container<std::string>(rc::gen::element('a', '1', ' ', ',', '"', '\n', ';'));
    const std::size_t columns = *rc::gen::inRange<std::size_t>(1, 5);
    const CsvRows rows = *rc::gen::nonEmpty(
        rc::gen::container<CsvRows>(rc::gen::container<std::vector<std::string>>(columns, cell)));
    RC_ASSERT(parse_csv(csv_text(rows), "a.csv") == rows);
}

// A cell that begins like the encoding mark of a file would lose this beginning, or be refused, when it is
// read back.
TEST(Csv, MarksOfEncodingsAreKeptInCells) {
    for (const std::string mark : {"\xEF\xBB\xBF", "\xFF\xFE", "\xFE\xFF"}) {
        const CsvRows rows{{mark + "row", mark}, {mark, "2"}};
        EXPECT_EQ(parse_csv(csv_text(rows), "a.csv"), rows);
    }
}

TEST(Csv, EndsOfLinesOfOtherSystemsAreRead) {
    EXPECT_EQ(parse_csv("a,b\r\n1,\"2\"\r\n", "a.csv"), (CsvRows{{"a", "b"}, {"1", "2"}}));
    EXPECT_EQ(parse_csv("\xEF\xBB\xBF\"a\",b\r1,2\r", "a.csv"), (CsvRows{{"a", "b"}, {"1", "2"}}));
}

TEST(Csv, DamageIsToldWithItsLine) {
    for (const auto& [text, words] :
         {std::pair{"a,b\n1\n", "a.csv:2: the row has 1 cells and the first one has 2"},
          std::pair{"a\n\"1\n", "a.csv:2: a quote is not closed"}})
        try {
            parse_csv(text, "a.csv");
            ADD_FAILURE() << text;
        } catch (const Error& error) {
            EXPECT_STREQ(error.what(), words);
        }
}

}  // namespace
}  // namespace sherd::test
