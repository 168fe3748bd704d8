// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/files/disk/journaled_file.h"

#include <fcntl.h>
#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "meshops/error.h"

namespace sherd {
namespace {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

constexpr auto patience = 2s;  // longest wait for locks of other programs

}  // namespace

JournaledFile::JournaledFile(std::filesystem::path file, std::chrono::milliseconds longest_wait)
    : disk(std::move(file), O_RDWR), longest_wait(longest_wait) {
    if (const std::optional<Journal> left = read_journal(disk)) {
        disk.lock_exclusive(patience);
        apply(*left, disk);
        disk.unlock();
    }
    stored = committed = end = disk.size();
    disk.sync();
    replace_journal(disk, {.end = end, .blocks = {}});
    sync_folder_of(disk.path());
}

JournaledFile::~JournaledFile() {
    try {
        if (failed || (!is_applied() && !disk.lock_exclusive(patience) && !disk.lock_shared())) return;
        apply_now();
        disk.sync();
        remove_journal(disk.path());
    } catch (const Error&) {
        return;  // the journal stays, and the next program that opens the file applies it
    }
}

bool JournaledFile::is_applied() const {
    return waiting.empty() && stored == committed;
}

Block JournaledFile::block(std::uint64_t number) const {
    Block content;
    read(number * block_size, content);
    return content;
}

void JournaledFile::read(std::uint64_t offset, std::span<std::byte> bytes) const {
    const auto below = [&](std::uint64_t limit) {
        return std::min<std::uint64_t>(bytes.size(), limit - std::min(limit, offset));
    };
    const auto old = bytes.first(below(std::min(end, stored)));
    disk.read(offset, old);
    overlay(waiting, offset, old);
    overlay(changed, offset, old);
    const auto behind = bytes.first(below(end)).subspan(old.size());
    if (!behind.empty())
        std::copy_n(tail.begin() + static_cast<std::ptrdiff_t>(offset + old.size() - stored), behind.size(),
                    behind.begin());
    std::ranges::fill(bytes.subspan(below(end)), std::byte{0});
}

void JournaledFile::write(std::uint64_t offset, std::span<const std::byte> bytes) {
    if (offset + bytes.size() > end) resize(offset + bytes.size());
    const std::uint64_t below = std::min<std::uint64_t>(bytes.size(), stored - std::min(stored, offset));
    visit_blocks(offset, bytes.first(below), [this](std::uint64_t number, std::size_t inside, auto part) {
        auto entry = changed.find(number);
        if (entry == changed.end()) entry = changed.emplace(number, block(number)).first;
        std::ranges::copy(part, entry->second.begin() + static_cast<std::ptrdiff_t>(inside));
    });
    if (const auto behind = bytes.subspan(below); !behind.empty())
        std::ranges::copy(behind, tail.begin() + static_cast<std::ptrdiff_t>(offset + below - stored));
}

void JournaledFile::resize(std::uint64_t size) {
    const std::uint64_t before = std::exchange(end, size);
    tail.resize(end - std::min(end, stored));
    if (const std::uint64_t old = std::min(end, stored); before < old)
        write(before, std::vector<std::byte>(old - before));  // bytes that had been cut off must not reappear
}

void JournaledFile::commit() {
    try {
        require_undisturbed();
        store();
    } catch (const Error&) {
        roll_back();
        throw;
    }
    changed.clear();
    tail.clear();
    stored = std::max(stored, end);
    committed = end;
    apply_unless_read();
}

void JournaledFile::roll_back() {
    changed.clear();
    tail.clear();
    end = committed;
}

void JournaledFile::require_undisturbed() const {
    const std::string name = "'" + disk.path().string() + "'";
    if (failed) throw Error(name + " cannot be changed any more after a disk error", Fault::run);
    if (!disk.is_in_place() || disk.size() != stored)
        throw Error(name + " has been removed, replaced or changed by another program", Fault::run);
    if (!disk.lock_shared(patience))
        throw Error("cannot write to " + name + ": another program has locked it; close that program",
                    Fault::run);
    disk.unlock();
}

void JournaledFile::store() {
    Journal journal{.end = end, .blocks = waiting};
    for (const auto& [number, content] : changed) journal.blocks[number] = content;
    // The file's last block before the change may be in the journal; its bytes beyond `stored` are in the
    // tail. Copies them into the journal's block.
    if (const auto last = journal.blocks.find(block_of(stored)); last != journal.blocks.end()) {
        const std::size_t inside = stored % block_size;
        std::copy_n(tail.begin(), std::min(tail.size(), block_size - inside),
                    last->second.begin() + static_cast<std::ptrdiff_t>(inside));
    }
    try {
        disk.write(stored, tail);
        or_fail([this] { disk.sync(); });
        replace_journal(disk, journal);
        or_fail([this] { sync_folder_of(disk.path()); });
    } catch (const Error&) {
        if (!failed) disk.resize(stored);
        throw;
    }
    waiting = std::move(journal.blocks);
}

void JournaledFile::apply_unless_read() {
    if (is_applied() || disk.lock_exclusive()) return apply_now();
    if (!waits_since) waits_since = Clock::now();
    if (Clock::now() - *waits_since > longest_wait && disk.lock_shared()) apply_now();
}

void JournaledFile::apply_now() {
    or_fail([this] { apply({.end = committed, .blocks = waiting}, disk); });
    waiting.clear();
    stored = committed;
    waits_since.reset();
    disk.unlock();
}

template <class Action>
void JournaledFile::or_fail(Action action) {
    failed = true;
    action();
    failed = false;
}

}  // namespace sherd
