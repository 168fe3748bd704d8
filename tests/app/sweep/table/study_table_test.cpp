// SPDX-License-Identifier: GPL-3.0-or-later
// Table, summary and chart of a study's results: users take their conclusions from these.
#include "app/sweep/table/study_table.h"

#include <gtest/gtest.h>

#include "app/sweep/study/study_measures.h"
#include "app/sweep/table/study_chart.h"
#include "app/sweep/table/study_summary.h"
#include "meshops/error.h"
#include "tests/support/program/temporary_directory.h"

namespace sherd::test {
namespace {

namespace fs = std::filesystem;

/// Two points of two rows each. The last row has failed, and the row before it has not been run.
struct FourRows {
    FourRows() {
        study.parameters = {{"sheet.plate.speed", {}, {}, {}}};
        study.measures = {"fragments"};
        for (std::size_t i = 0; i < 4; ++i) {
            StudyRow row{.values = {i < 2 ? "1" : "2"}, .point = i / 2, .choice = {}};
            row.seed = static_cast<std::int64_t>(1 + i % 2);
            row.identity = 10 + i;
            rows.rows.push_back(row);
        }
        add(10, 0, 3);
        add(11, 0, 5);
        add(13, 1, 0);
        results[13].message = "too \"stiff\", it says";
        results[13].values.clear();
    }

    void add(std::uint64_t identity, int exit_code, double fragments) {
        RowResult& result = results[identity];
        result.exit_code = exit_code;
        result.values = {{"fragments", fragments}};
        result.python = {{"bounce", fragments / 2}};
    }
    StudyTable table() const { return study_table(study, rows, results, "."); }

    Study study;
    StudyRows rows;
    RowResults results;
};

using Cells = std::vector<std::string>;

TEST(StudyTable, HasARowForEachRunInTheOrderOfTheStudy) {
    const StudyTable table = FourRows().table();
    EXPECT_EQ(find_column(table, "row").cells, (Cells{"0", "1", "2", "3"}));
    EXPECT_EQ(find_column(table, "speed").cells, (Cells{"1", "1", "2", "2"}))
        << "by the last part of its name";
    EXPECT_EQ(find_column(table, "fragments").cells, (Cells{"3", "5", "", ""}));
    EXPECT_EQ(find_column(table, "bounce").cells, (Cells{"1.5", "2.5", "", "0"}));
    EXPECT_EQ(find_column(table, "exit").cells, (Cells{"0", "0", "", "1"}));
    EXPECT_EQ(find_column(table, "message").cells[3], "too \"stiff\", it says");
    EXPECT_THROW(find_column(table, "fragmants"), Error);
}

TEST(StudyTable, IsReadBackFromItsFile) {
    const TemporaryDirectory folder;
    const StudyTable table = FourRows().table();
    const StudyTable again = read_study_table(folder.write("study.csv", csv_text(csv_rows(table))));
    ASSERT_EQ(again.size(), table.size());
    for (std::size_t i = 0; i < table.size(); ++i) {
        EXPECT_EQ(again[i].name, table[i].name);
        EXPECT_EQ(again[i].cells, table[i].cells);
    }
}

TEST(StudySummary, HasTheMeanOfEachPoint) {
    const FourRows four;
    const CsvRows summary = study_summary(four.rows, four.table());
    ASSERT_EQ(summary.size(), 3u);
    EXPECT_EQ(summary[0], (Cells{"sheet.plate.speed", "done", "failed", "fragments", "fragments.low",
                                 "fragments.high", "bounce", "bounce.low", "bounce.high"}));
    EXPECT_EQ(summary[1], (Cells{"1", "2", "0", "4", "3", "5", "2", "1.5", "2.5"}));
    EXPECT_EQ(summary[2], (Cells{"2", "0", "1", "", "", "", "0", "", ""}));
}

TEST(StudyChart, HasTheRowsAndTheirMeansWithIntervals) {
    const Chart chart = study_chart(FourRows().table(), {.x = "speed", .y = "fragments"});
    ASSERT_EQ(chart.series.size(), 2u);
    EXPECT_EQ(chart.series[0].points, (std::vector<Vector2d>{{1, 3}, {1, 5}}));
    EXPECT_EQ(chart.series[1].points, std::vector<Vector2d>{Vector2d(1, 4)});
    EXPECT_EQ(chart.series[1].intervals, std::vector<Vector2d>{Vector2d(3, 5)});
    const std::string svg = chart_svg(chart, 0, 0, 400, 300);
    EXPECT_NE(svg.find('V'), std::string::npos) << "the bar of the interval";
    EXPECT_THROW(study_chart(FourRows().table(), {.x = "message", .y = "fragments"}), Error);
}

TEST(StudyChart, WithoutRepeatsThereAreRowsOnly) {
    const Chart chart = study_chart(FourRows().table(), {.x = "row", .y = "fragments", .by = "seed"});
    ASSERT_EQ(chart.series.size(), 2u);
    EXPECT_EQ(chart.series[1].name, "seed = 2");
    EXPECT_FALSE(chart.series[1].joined);
}

TEST(StudyMeasures, AreThoseOfTheRun) {
    Measures measures;
    for (const double mass : {3., 2., 1.})
        measures.fragments.push_back({{0, -1, 1, 10 * mass, mass}, {4, 2}});
    measures.cracks = {0.5, 0.01};
    measures.lost_to_cracks = 2;
    measures.mass_law = PowerLaw{1.5, {1, 2}, 3};
    measures.peak_forces = {{{"obstacle.floor", "obstacle"}, 7, 0.1}, {{"sheet.a.pin", "pin"}, 9, 0.2}};
    const std::map<std::string, double> values = measure_values(measures);
    EXPECT_EQ(values.at("fragments"), 3);
    EXPECT_EQ(values.at("largest.mass"), 3);
    EXPECT_EQ(values.at("largest.area"), 30);
    EXPECT_EQ(values.at("largest.aspect_ratio"), 2);
    EXPECT_EQ(values.at("median_mass"), 2);
    EXPECT_EQ(values.at("mass_law.upper"), 2);
    EXPECT_EQ(values.at("energy_per_area"), 200);
    EXPECT_EQ(values.at("peak_force"), 9);
    EXPECT_EQ(values.at("peak_force.floor"), 7);
    EXPECT_EQ(values.at("peak_force_time.sheet.a.pin"), 0.2);
    EXPECT_FALSE(values.contains("first_crack.time")) << "nothing has failed";
    for (const auto& [name, value] : values) EXPECT_EQ(measure_error(name), "") << "a study can ask for it";
}

}  // namespace
}  // namespace sherd::test
