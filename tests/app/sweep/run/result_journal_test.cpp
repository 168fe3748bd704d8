// SPDX-License-Identifier: GPL-3.0-or-later
// A row that has a result must not be run again, whatever ended the program that recorded it.
#include "app/sweep/run/result_journal.h"

#include <gtest/gtest.h>

#include <fstream>

#include "app/files/disk/checksum.h"
#include "meshops/error.h"
#include "tests/support/program/temporary_directory.h"

namespace sherd::test {
namespace {

RowResult result_of(std::uint64_t identity, int exit_code) {
    RowResult result;
    result.identity = identity;
    result.program = 0xfedcba9876543210u;
    result.exit_code = exit_code;
    result.message = exit_code == 0 ? "" : "broke \"it\"\n\xff";
    result.wall_seconds = 0.1;
    result.values = {{"fragments", 3}};
    result.python = {{"z", 1.5}, {"a", 1 / 3.}};
    return result;
}

TEST(ResultJournal, WhatIsAppendedIsRead) {
    const TemporaryDirectory folder;
    ResultJournal journal(folder.path / "0-1.jsonl");
    journal.append(result_of(7, 0));
    journal.append(result_of(8, 1));
    const RowResults results = read_results(folder.path);
    ASSERT_EQ(results.size(), 2u);
    EXPECT_EQ(results.at(7).values, result_of(7, 0).values);
    EXPECT_EQ(results.at(7).python, result_of(7, 0).python) << "in the order of the file that measures";
    EXPECT_EQ(results.at(7).program, 0xfedcba9876543210u);
    EXPECT_EQ(results.at(8).exit_code, 1);
    EXPECT_TRUE(results.at(8).message.starts_with("broke \"it\"\n"));
}

TEST(ResultJournal, AHalfLineIsNothingAndIsCutOff) {
    const TemporaryDirectory folder;
    const std::filesystem::path file = folder.path / "0-1.jsonl";
    const std::string whole = to_line(result_of(7, 0)) + "\n", next = to_line(result_of(8, 0)) + "\n";
    for (std::size_t length = 0; length < next.size(); length += 7) {
        std::ofstream(file) << whole << next.substr(0, length);
        EXPECT_EQ(read_results(folder.path).size(), 1u) << length;
        ResultJournal(file).append(result_of(9, 0));
        EXPECT_EQ(text_of(file), whole + to_line(result_of(9, 0)) + "\n") << length;
    }
}

TEST(ResultJournal, TheLastOfARowCountsAndOfSeveralJournalsOneThatDidNotFail) {
    const TemporaryDirectory folder;
    ResultJournal one(folder.path / "a.jsonl"), other(folder.path / "b.jsonl");
    one.append(result_of(7, 1));
    one.append(result_of(7, 0));
    other.append(result_of(7, 2));
    other.append(result_of(8, 2));
    one.append(result_of(8, 0));
    const RowResults results = read_results(folder.path);
    EXPECT_EQ(results.at(7).exit_code, 0);
    EXPECT_EQ(results.at(8).exit_code, 0);
}

TEST(ResultJournal, HasOneWriter) {
    const TemporaryDirectory folder;
    const ResultJournal journal(folder.path / "a.jsonl");
    EXPECT_THROW(ResultJournal(folder.path / "a.jsonl"), Error);
}

}  // namespace
}  // namespace sherd::test
