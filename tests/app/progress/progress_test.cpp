// SPDX-License-Identifier: GPL-3.0-or-later
// Progress output on terminals of all widths, and without a terminal.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <regex>
#include <thread>

#include "app/progress/progress_display.h"
#include "app/progress/progress_line.h"
#include "app/progress/run_progress.h"
#include "app/recording/recording.h"
#include "tests/support/program/contains.h"
#include "tests/support/program/falling_disc.h"
#include "tests/support/program/program.h"
#include "tests/support/program/temporary_directory.h"
#include "tests/support/program/terminal.h"

namespace sherd::test {
namespace {

/// Two variants of a scene, whose runs nothing ends early.
const std::string variants = "[[variant]]\nname = \"slow\"\n[[variant]]\nname = \"diagonal\"\n";

RunProgress long_run() {
    return {123456, 0.00125, 0.025, 9.765625e-8, 98765, 4321, 12};
}

std::string line_of(const RunProgress& progress, std::size_t columns, const std::string& name = "") {
    const ProgressText text = progress_text(progress);
    ProgressStatus status{name, progress.time / progress.duration, text.before};
    status.parts.push_back({"ETA 12:34:56", 0});
    status.parts.insert(status.parts.end(), text.after.begin(), text.after.end());
    return progress_line(status, columns);
}

TEST(ProgressLine, IsShorterThanAnyTerminal) {
    for (const std::string name : {"", "slow", "a_name_that_is_longer_than_many_a_line_of_a_terminal"})
        for (std::size_t columns = 1; columns < 250; ++columns) {
            EXPECT_LT(line_of(long_run(), columns, name).size(), columns) << name;
            EXPECT_EQ(line_of(long_run(), columns, name).find('\n'), std::string::npos);
        }
}

// Readers of a log file must see that a long step is not the end of the program.
TEST(ProgressDisplay, SaysAgainHowFarThingsAreWhereNothingNewHappens) {
    testing::internal::CaptureStderr();
    const auto printed = [] {
        struct stat file {};
        EXPECT_EQ(fstat(STDERR_FILENO, &file), 0);
        return file.st_size;
    };
    const auto wait_for_more = [&](off_t than) {
        while (printed() <= than) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    };
    {
        ProgressMeter meter(10);
        ProgressDisplay display(0, std::chrono::milliseconds(1));
        display.begin();
        wait_for_more(0);
        meter.update(3, {{{"step 3", 0}}, {}});
        display.show(std::array{&meter});
        wait_for_more(printed());
    }
    const std::string text = testing::internal::GetCapturedStderr();
    EXPECT_TRUE(text.starts_with("sherd: nothing is done yet, after 0:00\n")) << text;
    EXPECT_TRUE(contains(text, "\n 30%  step 3  ETA 0:00\n")) << text;
    EXPECT_TRUE(contains(text, "\n 30%  step 3  ETA 0:00, after 0:00\n")) << text;
}

// Users look for the remaining time; details for experts are omitted first.
TEST(ProgressLine, LeavesOutTheLeastImportantFirst) {
    std::vector<std::string> words{"ETA", "0.00125 of 0.025 s", "fragments", "cracks", "step", "halved"};
    std::size_t there = 0;
    for (std::size_t columns = 20; columns < 200; ++columns) {
        const std::string line = line_of(long_run(), columns);
        const auto said =
            std::ranges::count_if(words, [&](const auto& word) { return contains(line, word); });
        for (std::size_t i = 0; i < words.size(); ++i)
            EXPECT_EQ(contains(line, words[i]), static_cast<std::ptrdiff_t>(i) < said) << line;
        EXPECT_GE(static_cast<std::size_t>(said), there) << line;
        there = static_cast<std::size_t>(said);
    }
    EXPECT_EQ(there, words.size());
    EXPECT_TRUE(contains(line_of(long_run(), 80), "fragments"));
}

TEST(ProgressLine, CountsCharactersAndNotBytes) {
    const ProgressStatus status{"na\xc3\xafve", 0.5, {{"\xe2\x80\xa6\xe2\x80\xa6", 0}}};
    const std::string line = progress_line(status, 22);
    EXPECT_EQ(line, "na\xc3\xafve [#####.....] \xe2\x80\xa6\xe2\x80\xa6");
}

TEST(ProgressLine, AnHourHasHoursAndNoTimeIsTooLong) {
    EXPECT_EQ(clock_text(59.6), "1:00");
    EXPECT_EQ(clock_text(3661), "1:01:01");
    EXPECT_EQ(clock_text(1e300), "999:00:00");
}

TEST(RunProgress, PassesThroughALine) {
    const RunProgress before = long_run();
    const auto after = run_progress(to_line(before));
    ASSERT_TRUE(after);
    EXPECT_EQ(to_line(*after), to_line(before));
    EXPECT_EQ(after->time, before.time);
    EXPECT_EQ(after->halvings, 12);
    EXPECT_FALSE(run_progress("sherd: warning: of something else"));
}

/// Number of lines with a bar that were too long for the screen. (The table at the end may be wider than a
/// terminal.)
std::ptrdiff_t wrapped_bars(const Screen& screen) {
    return std::ranges::count_if(screen.wrapped, [](const auto& line) { return contains(line, "["); });
}

/// Result of a complete run on a terminal: the screen at the end, all bytes of output, and the exit code.
struct Shown {
    Screen screen;
    std::string bytes;
    int exit_code;
};

Shown run_on_terminal(std::vector<std::string> arguments, const TemporaryDirectory& directory,
                      unsigned short columns, const std::string& kind = "xterm") {
    TerminalProgram program(std::move(arguments), directory.path, columns, kind);
    const std::string bytes = program.read_to_end();
    Screen screen(columns);
    screen.add(bytes);
    return {screen, bytes, program.exit_code};
}

class ProgressOnATerminal : public testing::Test {
  protected:
    void SetUp() override {
        const int terminal = open_pseudo_terminal();
        if (terminal < 0) GTEST_SKIP() << "this machine makes no pseudo terminals: is /dev/pts mounted?";
        close(terminal);
    }
};

TEST_F(ProgressOnATerminal, NeverWrapsAndLeavesOneLine) {
    const TemporaryDirectory directory;
    directory.write("scene.toml", falling_disc);
    for (const unsigned short columns : {80, 60}) {
        const Shown shown = run_on_terminal({"run", "scene.toml", "--force"}, directory, columns);
        EXPECT_EQ(shown.exit_code, 0) << shown.bytes;
        EXPECT_EQ(wrapped_bars(shown.screen), 0);
        const auto text = shown.screen.text();
        ASSERT_GE(text.size(), 2u);
        EXPECT_TRUE(text[0].starts_with("[####")) << text[0];
        EXPECT_TRUE(contains(text[0], "0.002 of 0.002 s  took 0:0")) << text[0];
        EXPECT_TRUE(text[1].starts_with("run                   complete")) << text[1];
    }
}

TEST_F(ProgressOnATerminal, FitsAfterTheTerminalHasBecomeNarrower) {
    const TemporaryDirectory directory;
    directory.write("scene.toml", falling_disc);
    TerminalProgram program({"run", "scene.toml", "--set", "duration=1000"}, directory.path, 100);
    const auto redraws = [](const std::string& text) { return std::ranges::count(text, '\r'); };
    const std::string wide = program.read_until([&](const auto& text) { return redraws(text) >= 6; });
    Screen before(100);
    before.add(wide);
    EXPECT_EQ(wrapped_bars(before), 0);
    EXPECT_GT(before.text().at(0).size(), 60u) << "the test would prove nothing";

    program.resize_at_rest(60);
    // The program may have composed a line for the old width before; lines are counted by their carriage
    // returns.
    program.read_until([&](const auto& text) { return redraws(text) >= 3; });
    Screen after(60);
    after.add(program.read_until([&](const auto& text) { return redraws(text) >= 6; }));
    EXPECT_EQ(wrapped_bars(after), 0);
    EXPECT_TRUE(after.text().at(0).starts_with("[")) << after.text().at(0);

    program.type("\x03");
    const std::string end = program.read_to_end();
    after.add(end);
    EXPECT_EQ(program.exit_code, 130);
    EXPECT_EQ(wrapped_bars(after), 0) << "what Ctrl-C echoes made the line wrap";
    EXPECT_EQ(after.column, 0u) << "a shell's prompt would come behind something";
    EXPECT_TRUE(contains(after.text().at(0), "] ")) << after.text().at(0);
    EXPECT_TRUE(contains(after.text().at(1), "run                   interrupted")) << after.text().at(1);
    EXPECT_EQ(Recording(directory.path / "scene.h5").end(), "interrupted");
}

TEST_F(ProgressOnATerminal, OfVariantsIsALineForEachThatIsDrawnInPlace) {
    const TemporaryDirectory directory;
    directory.write("scene.toml", falling_disc + variants);
    for (const unsigned short columns : {80, 60}) {
        TerminalProgram program({"run", "scene.toml", "--force", "--set", "duration=1000"}, directory.path,
                                columns);
        const std::regex both(
            "slow +\\[[#.]+\\] [0-9.e-]+ of 1000 s  ETA [^\\n]*\\n"
            "diagonal \\[[#.]+\\] [0-9.e-]+ of 1000 s  ETA [^\\n]*\\r[^\\n]*\\r");
        const std::regex steps("step [0-9]+  ");
        std::string bytes;
        const auto drawn = [&](const std::string& text) {
            return std::regex_search(std::regex_replace(text, steps, ""), both);
        };
        bytes = program.read_until(drawn);
        Screen screen(columns);
        screen.add(bytes);
        EXPECT_EQ(wrapped_bars(screen), 0);
        ASSERT_EQ(screen.text().size(), 2u) << bytes;
        EXPECT_TRUE(screen.text()[0].starts_with("slow     [")) << bytes;
        EXPECT_TRUE(screen.text()[1].starts_with("diagonal [")) << bytes;

        program.type("\x03");
        screen.add(program.read_to_end());
        EXPECT_EQ(program.exit_code, 130);
        EXPECT_EQ(wrapped_bars(screen), 0);
        EXPECT_EQ(screen.column, 0u);
        const auto text = screen.text();
        for (const std::string name : {"slow     [", "diagonal ["})
            EXPECT_EQ(std::ranges::count_if(text, [&](const auto& line) { return line.starts_with(name); }),
                      1)
                << name << " has left more than its last line:\n"
                << bytes;
        for (const std::string name : {"slow", "diagonal"})
            EXPECT_EQ(Recording(directory.path / ("scene-" + name + ".h5")).end(), "interrupted");
    }
}

TEST_F(ProgressOnATerminal, OfVariantsThatEndLeavesALineAndATableOfEach) {
    const TemporaryDirectory directory;
    directory.write("scene.toml", falling_disc + variants);
    const Shown shown = run_on_terminal({"run", "scene.toml"}, directory, 80);
    EXPECT_EQ(shown.exit_code, 0);
    EXPECT_EQ(wrapped_bars(shown.screen), 0);
    const auto text = shown.screen.text();
    for (const std::string name : {"slow     ", "diagonal "}) {
        const auto line =
            std::ranges::find_if(text, [&](const auto& l) { return l.starts_with(name + "["); });
        ASSERT_NE(line, text.end()) << shown.bytes;
        EXPECT_TRUE(contains(*line, "[##########")) << *line;
        EXPECT_TRUE(contains(*line, "0.002 of 0.002 s  took 0:0")) << *line;
        EXPECT_TRUE(contains(*(line + 1), "variant " + name.substr(0, name.find(' ')))) << *(line + 1);
    }
}

TEST_F(ProgressOnATerminal, OnADumbTerminalIsALineForEachTenthWithoutEscapes) {
    const TemporaryDirectory directory;
    directory.write("scene.toml", falling_disc);
    const Shown shown = run_on_terminal({"run", "scene.toml"}, directory, 80, "dumb");
    EXPECT_EQ(shown.exit_code, 0);
    EXPECT_FALSE(contains(shown.bytes, "\x1b"));
    EXPECT_FALSE(contains(shown.bytes, "\r"));
    EXPECT_TRUE(contains(shown.bytes, "\n 20%  step 4  0.0004 of 0.002 s  ETA 0:0")) << shown.bytes;
}

TEST(Progress, OfAFileIsALineForEachTenth) {
    const TemporaryDirectory directory;
    directory.write("scene.toml", falling_disc + variants);
    for (const bool all : {false, true}) {
        std::vector<std::string> arguments{"run", "scene.toml", "--force"};
        if (!all) arguments.insert(arguments.end(), {"--variant", "slow"});
        const ProgramResult result = run_sherd(arguments, directory.path);
        ASSERT_EQ(result.exit_code, 0) << result.err;
        EXPECT_FALSE(contains(result.err, "\r") || contains(result.err, "\x1b")) << result.err;
        const std::string name = all ? "slow: " : "";
        std::size_t at = 0;
        for (int tenth = 1; tenth <= 10; ++tenth) {
            at = result.err.find(fmt::format("{}{:3}%  step {}  ", name, 10 * tenth, 2 * tenth), at);
            ASSERT_NE(at, std::string::npos) << tenth << "\n" << result.err;
        }
        EXPECT_FALSE(contains(result.err, "  5%") || contains(result.err, " 15%")) << result.err;
    }
}

}  // namespace
}  // namespace sherd::test
