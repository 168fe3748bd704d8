// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/plot.h"

#include <gtest/gtest.h>

#include <fstream>
#include <limits>
#include <numeric>

#include "app/render/legend/axis_ticks.h"
#include "meshops/error.h"
#include "tests/support/program/program.h"
#include "tests/support/program/temporary_directory.h"
#include "tests/support/recording/synthetic_run.h"

namespace sherd::test {
namespace {

using Numbers = std::vector<double>;

/// Number of occurrences of `word` in `text`.
int count(const std::string& text, const std::string& word) {
    int found = 0;
    for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) ++found;
    return found;
}

void expect_numbers_near(const Numbers& found, const Numbers& expected) {
    ASSERT_EQ(found.size(), expected.size()) << ::testing::PrintToString(found);
    for (std::size_t i = 0; i < found.size(); ++i) EXPECT_NEAR(found[i], expected[i], 1e-9 * expected.back());
}

TEST(PlotTicks, AreRound) {
    expect_numbers_near(round_ticks(0, 10, 6, false), {0, 2, 4, 6, 8, 10});
    expect_numbers_near(round_ticks(0.0013, 0.0041, 6, false), {0.0015, 0.002, 0.0025, 0.003, 0.0035, 0.004});
    expect_numbers_near(round_ticks(0, 2, 6, true), {0, 1, 2});
    expect_numbers_near(round_ticks(-30, 70, 6, false), {-20, 0, 20, 40, 60});
    expect_numbers_near(logarithmic_ticks(1e-3, 10), {1e-3, 1e-2, 1e-1, 1, 10});
    expect_numbers_near(logarithmic_ticks(1, 20), {1, 2, 5, 10, 20});
}

// Researchers look for a peak of one step among a million, which must not be thinned out.
TEST(PlotThinning, KeepsTheExtremesAndTheEnds) {
    std::vector<Vector2d> points;
    for (int i = 0; i < 100000; ++i) points.emplace_back(i, i % 7);
    points[12345].y() = 1000;
    points[77777].y() = -1000;
    const std::vector<Vector2d> kept = thinned(points, 400);
    EXPECT_LE(kept.size(), 1600u);
    EXPECT_EQ(kept.front(), points.front());
    EXPECT_EQ(kept.back(), points.back());
    for (const int peak : {12345, 77777}) EXPECT_TRUE(std::ranges::count(kept, points[peak])) << peak;
    EXPECT_TRUE(std::ranges::is_sorted(kept, {}, [](const Vector2d& p) { return p.x(); }));
    EXPECT_EQ(thinned(kept, 400).size(), kept.size());
}

/// Events of the synthetic run in one list.
CrackEvents all_events(const SyntheticRun& run) {
    CrackEvents events;
    for (const CrackEvents& later : run.events) append(events, later);
    return events;
}

TEST(Plot, CrackLengthIsThatOfTheFailedEdgesAtRest) {
    const SyntheticRun run = synthetic_run();
    const CrackEvents events = all_events(run);
    const Snapshot& last = run.frames.back();
    const std::vector<Vector2d> length = crack_length(last, events, 0.5);
    ASSERT_EQ(length.size(), events.failures.size() + 2);
    EXPECT_EQ(length.front(), Vector2d(0, 0));
    EXPECT_EQ(length.back().x(), 0.5);
    double expected = 0;
    for (const EdgeFailure& failure : events.failures) {
        const auto [a, b] = failure.vertices;
        expected +=
            (run.header.rest_position.col(last.original[a]) - run.header.rest_position.col(last.original[b]))
                .norm();
    }
    EXPECT_GT(expected, 0.01);
    EXPECT_NEAR(length.back().y(), expected, 1e-12);
}

TEST(Plot, FragmentSizesShareOutTheSheet) {
    const SyntheticRun run = synthetic_run();
    const std::vector<Vector2d> sizes = fragment_sizes(run.frames.back());
    ASSERT_EQ(sizes.size(), 3u);
    double area = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        area += sizes[i].x();
        EXPECT_EQ(sizes[i].y(), 3.0 - static_cast<double>(i));
        EXPECT_GE(sizes[i].x(), sizes[i > 0 ? i - 1 : 0].x());
    }
    EXPECT_NEAR(area, std::accumulate(run.header.rest_area.begin(), run.header.rest_area.end(), 0.0), 1e-14);
}

// The plot has nine charts with units, in XML that remains valid with a strange scene name.
TEST(Plot, DrawsChartsWithUnits) {
    const TemporaryDirectory folder;
    record(synthetic_run(), folder.path / "run.h5");
    const std::string svg = plot_svg(Recording(folder.path / "run.h5"));
    EXPECT_EQ(count(svg, "<g>"), 9);
    for (const char* word : {"Energy", "Work and losses", "Fragments", "Length of all cracks",
                             "Fragment sizes", "kinetic", "membrane", ">time (", "Forces of supports",
                             "Gauges", ">floor<", ">tip<", "strip &amp; &quot;strip&quot;.toml", "</svg>"})
        EXPECT_GT(count(svg, word), 0) << word;
    EXPECT_EQ(count(svg, "nan") + count(svg, "inf"), 0);
    EXPECT_EQ(count(svg, "<circle"), 3) << "a dot for each fragment";
}

// An empty chart would look like a balance in which nothing was lost.
TEST(Plot, HasNoChartOfABalanceThatWasNotRecorded) {
    const TemporaryDirectory folder;
    record(synthetic_run(), folder.path / "run.h5");
    remove_balance(folder.path / "run.h5");
    const std::string svg = plot_svg(Recording(folder.path / "run.h5"));
    EXPECT_EQ(count(svg, "<g>"), 8);
    EXPECT_EQ(count(svg, "Work and losses"), 0);
}

// Loads and speeds of tips have charts, with gaps where a tip does not exist. Without tips there are no
// charts.
TEST(Plot, ShowsTipsOfCracksOverTime) {
    SyntheticRun run = synthetic_run();
    add_tips(run);
    run.events[1].tips[0].released = 0;  // zero has no place on a logarithmic axis
    const TemporaryDirectory folder;
    record(run, folder.path / "run.h5");
    const std::string svg = plot_svg(Recording(folder.path / "run.h5"));
    EXPECT_EQ(count(svg, "<g>"), 11);
    for (const char* word : {"Energy released at tips", "Speed of tips", ">G / G_c<", "speed (km/s)"})
        EXPECT_EQ(count(svg, word), 1) << word;
    EXPECT_EQ(count(svg, ">tip 0<"), 2);
    EXPECT_LT(svg.find(">tip 1<"), svg.find(">tip 0<")) << "the one that was there longer is first";
    EXPECT_EQ(count(svg, "nan") + count(svg, "inf"), 0);
}

// A run that diverged must still have a plot of the time before it diverged.
TEST(Plot, LeavesGapsWhereNumbersAreNotFinite) {
    SyntheticRun run = synthetic_run();
    run.steps[2][3].kinetic = std::numeric_limits<double>::quiet_NaN();
    run.steps[2][4].bending = std::numeric_limits<double>::infinity();
    const TemporaryDirectory folder;
    record(run, folder.path / "run.h5");
    const std::string svg = plot_svg(Recording(folder.path / "run.h5"));
    EXPECT_EQ(count(svg, "nan") + count(svg, "inf"), 0);
}

TEST(Plot, WritesBesideTheRecordingAndKeepsWhatIsThere) {
    const TemporaryDirectory folder;
    record(synthetic_run(), folder.path / "run.h5");
    const ProgramResult first = run_sherd({"plot", "run.h5"}, folder.path);
    EXPECT_EQ(first.exit_code, 0) << first.err;
    EXPECT_EQ(first.out, "run.svg\n");
    const auto before = folder.contents();
    EXPECT_EQ(run_sherd({"plot", "run.h5"}, folder.path).exit_code, 2);
    EXPECT_EQ(folder.contents(), before);
    EXPECT_EQ(run_sherd({"plot", "run.h5", "--force"}, folder.path).exit_code, 0);
    EXPECT_EQ(folder.contents(), before) << "the same bytes again";
}

TEST(Plot, RefusesARunThatHasJustBegun) {
    const TemporaryDirectory folder;
    { const RecordingWriter begun(folder.path / "run.h5", synthetic_run().header, false); }
    EXPECT_THROW(plot_svg(Recording(folder.path / "run.h5")), Error);
}

// Each quantity that gauges record has a chart of its own, with only the gauges that record it.
TEST(Plot, DrawsWhatGaugesRecord) {
    const TemporaryDirectory folder;
    SyntheticRun run = synthetic_run();
    const auto drawn = [&](const char* name) {
        record(run, folder.path / name);
        return plot_svg(Recording(folder.path / name));
    };
    const std::string plain = drawn("plain.h5");
    EXPECT_EQ(count(plain, "largest principal stress"), 0);
    add_fields(run);
    const std::string all = drawn("all.h5");
    EXPECT_EQ(count(all, "largest principal stress"), 1);
    EXPECT_EQ(count(all, "principal membrane strain"), 1);
    EXPECT_EQ(count(all, "principal curvature"), 0);
    EXPECT_EQ(count(all, "Gauges: tip"), 2);
    EXPECT_EQ(count(all, "Gauges: middle"), 1);
}

}  // namespace
}  // namespace sherd::test
