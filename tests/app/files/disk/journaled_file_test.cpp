// SPDX-License-Identifier: GPL-3.0-or-later
// A journaled file must have its last committed content, whenever the program or the machine ends: otherwise
// a recording would be lost.
#include "app/files/disk/journaled_file.h"

#include <gtest/gtest.h>
#include <sys/file.h>

#include <cstring>
#include <random>
#include <thread>

#include "app/files/disk/overlaid_file.h"
#include "meshops/error.h"
#include "tests/support/program/simulated_disk.h"
#include "tests/support/program/system_calls.h"
#include "tests/support/program/temporary_directory.h"

namespace sherd::test {
namespace {

namespace fs = std::filesystem;

std::string random_bytes(std::size_t size, std::mt19937& random) {
    std::string bytes(size, '\0');
    for (char& byte : bytes) byte = static_cast<char>(random());
    return bytes;
}

std::string content(const ByteFile& file) {
    std::string bytes(file.size(), '\0');
    file.read(0, std::as_writable_bytes(std::span(bytes)));
    return bytes;
}

/// Makes a random change, as HDF5 makes them, both to a file and to a string with the same content.
void change(JournaledFile& file, std::string& same, std::mt19937& random) {
    if (random() % 8 == 0) {
        const std::size_t size = random() % (same.size() + 700);
        file.resize(size);
        same.resize(size);
        return;
    }
    const std::size_t offset = random() % (same.size() + 300);
    const std::string bytes = random_bytes(1 + random() % 1500, random);
    file.write(offset, std::as_bytes(std::span(bytes)));
    same.resize(std::max(same.size(), offset + bytes.size()));
    same.replace(offset, bytes.size(), bytes);
}

/// A file that is changed several times: its committed states, and all system calls.
struct History {
    explicit History(unsigned seed, bool with_reader) {
        std::mt19937 random(seed);
        states.push_back(random_bytes(random() % 5000, random));
        const fs::path file = folder.write("run.h5", states[0]);
        before = folder.contents();
        SystemCalls calls(folder.path);
        {
            std::optional<DiskFile> reader;
            JournaledFile journaled(file);
            opened = calls.made.size();
            for (int i = 0; i < 5; ++i) {
                if (with_reader && i == 1) reader.emplace(file, O_RDONLY).lock_shared();
                if (i == 4) reader.reset();
                commit(journaled, random);
                done.push_back(calls.made.size());
                EXPECT_EQ(content(OverlaidFile(file, {})), states.back());
            }
        }
        made = std::move(calls.made);
        EXPECT_EQ(folder.contents().at(file.string()), states.back());
        EXPECT_EQ(folder.contents().size(), 1u) << "the journal is left";
    }

    void commit(JournaledFile& journaled, std::mt19937& random) {
        std::string state = states.back();
        if (random() % 3 == 0) {
            for (int i = 0; i < 3; ++i) change(journaled, state, random);
            journaled.roll_back();
            state = states.back();
        }
        const std::size_t changes = random() % 6;
        for (std::size_t i = 0; i < changes; ++i) change(journaled, state, random);
        EXPECT_EQ(content(journaled), state) << "before it is committed";
        journaled.commit();
        EXPECT_EQ(content(journaled), state);
        states.push_back(state);
    }

    /// Number of the last state that was committed before the system call of this number.
    std::size_t committed(std::size_t call) const {
        return static_cast<std::size_t>(
            std::ranges::count_if(done, [&](std::size_t i) { return i <= call; }));
    }

    TemporaryDirectory folder;
    std::map<std::string, std::string> before;
    std::vector<std::string> states;
    std::vector<SystemCall> made;
    std::size_t opened = 0;
    std::vector<std::size_t> done;  ///< number of calls until the end of each commit
};

/// Expects that a file has the last committed state or the next one, if its program ended before the system
/// call of this number: readers must see that before and after repair.
void expect_one_of(const History& history, std::size_t call, const fs::path& file) {
    const std::size_t last = history.committed(call);
    const std::string read = content(OverlaidFile(file, {}));
    const bool is_next = last + 1 < history.states.size() && read == history.states[last + 1];
    // Before the first journal no committed size is stored, but nothing has been written behind the end yet,
    // either.
    ASSERT_TRUE(is_next || read == history.states[last])
        << "at call " << call << " of " << history.made.size();
    recover(file);
    EXPECT_EQ(content(OverlaidFile(file, {})), read) << "mended at call " << call;
    EXPECT_EQ(fs::file_size(file), read.size());
    EXPECT_FALSE(has_journal(file));
}

void expect_survives(unsigned seed, bool with_reader, int draws) {
    SCOPED_TRACE("seed " + std::to_string(seed) + (with_reader ? " with a reader" : ""));
    const History history(seed, with_reader);
    std::mt19937 random(seed);
    const TemporaryDirectory after;
    const fs::path file = after.path / "run.h5";
    SimulatedDisk disk(history.before);
    for (std::size_t call = 0; call <= history.made.size(); ++call) {
        for (int draw = 0; draw < draws; ++draw) {
            disk.show(after.path, draw == 0, random);
            expect_one_of(history, call, file);
            if (::testing::Test::HasFailure()) return;
        }
        if (call < history.made.size()) disk.make(history.made[call]);
    }
}

TEST(JournaledFile, IsWhatWasCommittedLastAfterAnyEnd) {
    for (unsigned seed = 0; seed < 12; ++seed) expect_survives(seed, seed % 2 == 1, 6);
}

TEST(LongJournaledFile, IsWhatWasCommittedLastAfterAnyEnd) {
    const unsigned seeds = std::getenv("SHERD_SHORT") == nullptr ? 400 : 40;
    for (unsigned seed = 100; seed < 100 + seeds; ++seed) expect_survives(seed, seed % 2 == 1, 12);
}

// A writer must continue where another writer was ended, and may be ended, too.
TEST(JournaledFile, GoesOnAfterAnyEnd) {
    const History history(3, true);
    std::mt19937 random(3);
    const TemporaryDirectory after;
    const fs::path file = after.path / "run.h5";
    SimulatedDisk disk(history.before);
    for (const SystemCall& call : history.made) {
        disk.make(call);
        disk.show(after.path, false, random);
        std::string state = content(OverlaidFile(file, {}));
        {
            JournaledFile journaled(file);
            EXPECT_EQ(content(journaled), state);
            change(journaled, state, random);
            journaled.commit();
        }
        EXPECT_EQ(after.contents().at(file.string()), state);
    }
}

/// A file that is changed until a call fails, and then once more.
struct Failure {
    Failure(std::size_t failing, int reason) {
        const fs::path file = folder.write("run.h5", states.back());
        {
            JournaledFile journaled(file);
            SystemCalls calls(folder.path);
            calls.failing = failing;
            calls.reason = reason;
            while (states.size() < 6 && commit(journaled)) continue;
            failed = states.size() < 6;
            goes_on = failed && commit(journaled);
        }
        const std::string read = content(OverlaidFile(file, {}));
        EXPECT_TRUE(read == states.back() || (!goes_on && read == next)) << "call " << failing;
        recover(file);
        EXPECT_EQ(folder.contents().at(file.string()), read);
    }

    bool commit(JournaledFile& journaled) {
        std::string state = states.back();
        try {
            for (int k = 0; k < 3; ++k) change(journaled, state, random);
            journaled.commit();
            states.push_back(state);
            return true;
        } catch (const Error& error) {
            EXPECT_EQ(error.fault, Fault::run);
            EXPECT_NE(std::string(error.what()).find(folder.path.string()), std::string::npos)
                << error.what();
            if (next.empty()) next = state;
            return false;
        }
    }

    TemporaryDirectory folder;
    std::mt19937 random{7};
    std::vector<std::string> states{random_bytes(3000, random)};
    std::string next;  ///< content that could not be committed
    bool failed = false, goes_on = false;
};

// A failing call must not destroy committed data.
TEST(JournaledFile, KeepsWhatWasCommittedWhenACallFails) {
    for (const int reason : {ENOSPC, EIO}) {
        std::size_t call = 0, went_on = 0;
        for (bool failed = true; failed && call < 1000; ++call) {
            const Failure failure(call, reason);
            failed = failure.failed;
            went_on += failure.goes_on;
        }
        EXPECT_GT(call, 20u);
        EXPECT_GT(went_on, 3u) << "without room for an append or a journal it can be tried again";
    }
}

TEST(JournaledFile, WaitsForNoReaderAndDoesNotChangeTheFileUnderOne) {
    const TemporaryDirectory folder;
    const fs::path file = folder.write("run.h5", "as it was");
    JournaledFile journaled(file);
    std::optional<OverlaidFile> reader(std::in_place, file, std::chrono::milliseconds(0));
    const std::string next = "as it is now";
    const auto start = std::chrono::steady_clock::now();
    journaled.write(0, std::as_bytes(std::span(next)));
    journaled.commit();
    EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(1));
    EXPECT_EQ(content(*reader), "as it was");
    EXPECT_TRUE(folder.contents().at(file.string()).starts_with("as it was"));
    EXPECT_EQ(content(OverlaidFile(file, {})), next) << "who comes later reads the journal";
    reader.reset();
    journaled.commit();
    EXPECT_EQ(folder.contents().at(file.string()), next);
}

// h5py, which ignores journals, must get new data even if another reader keeps the file open all day.
TEST(JournaledFile, ChangesTheFileUnderAReaderAfterItsLongestWait) {
    const TemporaryDirectory folder;
    const fs::path file = folder.write("run.h5", "as it was");
    constexpr auto longest_wait = std::chrono::milliseconds(20);
    JournaledFile journaled(file, longest_wait);
    const DiskFile reader(file, O_RDONLY);
    reader.lock_shared();
    const std::string next = "as it is now";
    journaled.write(0, std::as_bytes(std::span(next)));
    journaled.commit();
    std::this_thread::sleep_for(2 * longest_wait);
    EXPECT_TRUE(folder.contents().at(file.string()).starts_with("as it was"));
    journaled.commit();
    EXPECT_EQ(folder.contents().at(file.string()), next);
}

/// Returns the content of a folder with a committed file, whose writer was killed before it changed the file
/// itself.
std::map<std::string, std::string> left_by_a_killed_writer(const TemporaryDirectory& folder) {
    const fs::path file = folder.write("run.h5", std::string(2000, 'a'));
    JournaledFile journaled(file);
    const OverlaidFile reader(file, {});
    const std::string next(700, 'b');
    journaled.write(100, std::as_bytes(std::span(next)));
    journaled.commit();
    return folder.contents();
}

// A journal that lies beside another file of the same name would destroy this file.
TEST(JournaledFile, TakesNoJournalOfAnotherFile) {
    TemporaryDirectory folder;
    const fs::path file = folder.path / "run.h5";
    const auto left = left_by_a_killed_writer(folder);
    for (const std::string& other : {std::string(2000, 'c'), std::string(100, 'a'), std::string()}) {
        folder.write("run.h5.journal", left.at(file.string() + ".journal"));
        folder.write("run.h5", other);
        EXPECT_EQ(content(OverlaidFile(file, {})), other);
        EXPECT_NE(recover(file).find("does not fit"), std::string::npos);
        EXPECT_EQ(folder.contents().at(file.string()), other);
    }
    folder.write("run.h5", left.at(file.string()));
    EXPECT_NE(recover(file).find("which is complete now"), std::string::npos);
    EXPECT_EQ(folder.contents().at(file.string()),
              std::string(100, 'a') + std::string(700, 'b') + std::string(1200, 'a'));
}

TEST(JournaledFile, DropsAnIncompleteJournal) {
    const TemporaryDirectory folder;
    const fs::path file = folder.path / "run.h5";
    const auto left = left_by_a_killed_writer(folder);
    const std::string journal = left.at(file.string() + ".journal");
    for (std::size_t size = 0; size < journal.size(); size += 97) {
        folder.write("run.h5", std::string(2000, 'a'));
        folder.write("run.h5.journal", journal.substr(0, size));
        EXPECT_EQ(content(OverlaidFile(file, {})), std::string(2000, 'a'));
        EXPECT_NE(recover(file).find("incomplete"), std::string::npos);
        EXPECT_EQ(folder.contents().at(file.string()), std::string(2000, 'a'));
    }
    std::string changed = journal;
    changed[journal.size() / 2] ^= 1;
    folder.write("run.h5.journal", changed);
    EXPECT_EQ(content(OverlaidFile(file, {})), std::string(2000, 'a'));
}

TEST(JournaledFile, IsNotChangedBesideAnotherProgram) {
    const TemporaryDirectory folder;
    const fs::path file = folder.write("run.h5", "as it was");
    JournaledFile journaled(file);
    const std::string next = "as it is now";
    const auto refusal = [&]() -> std::string {
        try {
            journaled.write(0, std::as_bytes(std::span(next)));
            journaled.commit();
        } catch (const Error& error) {
            return error.what();
        }
        return "";
    };
    folder.write("run.h5", "as somebody else has written it");
    EXPECT_NE(refusal().find("changed by another program"), std::string::npos);
    EXPECT_EQ(folder.contents().at(file.string()), "as somebody else has written it");
    fs::rename(file, folder.path / "other.h5");
    EXPECT_NE(refusal().find("removed"), std::string::npos);
    fs::rename(folder.path / "other.h5", file);
    folder.write("run.h5", "as it was");
    EXPECT_EQ(refusal(), "");
}

}  // namespace
}  // namespace sherd::test
