// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/files/disk/journal.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <utility>
#include <vector>

#include "app/files/disk/checksum.h"
#include "app/files/disk/output_lock.h"
#include "meshops/error.h"

namespace sherd {
namespace {

namespace fs = std::filesystem;

using Bytes = std::vector<std::byte>;

constexpr std::array<char, 8> magic{'S', 'h', 'e', 'r', 'd', 'J', '1', '\n'};
constexpr std::size_t number_size = sizeof(std::uint64_t);
// Parts of a journal: head, entries, checksum of all bytes before it.
constexpr std::size_t head_size = magic.size() + 2 * number_size;  // magic, file size, number of blocks
constexpr std::size_t entry_size = 2 * number_size + block_size;   // number, old content's checksum, content
constexpr std::size_t least_size = head_size + number_size;        // head and checksum, without entries

fs::path journal_of(const fs::path& file) {
    return file.string() + ".journal";
}

std::uint64_t checksum_of_bytes(std::span<const std::byte> bytes) {
    return checksum({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
}

void put(Bytes& bytes, const void* from, std::size_t size) {
    const auto* begin = static_cast<const std::byte*>(from);
    bytes.insert(bytes.end(), begin, begin + size);
}

std::uint64_t number_at(std::span<const std::byte> bytes, std::size_t offset) {
    std::uint64_t number;
    std::memcpy(&number, bytes.data() + offset, number_size);
    return number;
}

/// Returns the number of bytes of block `number` that lie within a file of `end` bytes.
std::size_t length_of(std::uint64_t number, std::uint64_t end) {
    const std::uint64_t start = number * block_size;
    return end <= start ? 0 : std::min<std::uint64_t>(block_size, end - start);
}

std::uint64_t stored_checksum(const DiskFile& file, std::uint64_t number, std::size_t length) {
    Block block;
    const auto part = std::span(block).first(length);
    file.read(number * block_size, part);
    return checksum_of_bytes(part);
}

Bytes encoded(const DiskFile& file, const Journal& journal) {
    Bytes bytes;
    bytes.reserve(least_size + entry_size * journal.blocks.size());
    const std::uint64_t count = journal.blocks.size();
    put(bytes, magic.data(), magic.size());
    put(bytes, &journal.end, number_size);
    put(bytes, &count, number_size);
    for (const auto& [number, block] : journal.blocks) {
        const std::uint64_t before = stored_checksum(file, number, length_of(number, journal.end));
        put(bytes, &number, number_size);
        put(bytes, &before, number_size);
        put(bytes, block.data(), block_size);
    }
    const std::uint64_t sum = checksum_of_bytes(bytes);
    put(bytes, &sum, number_size);
    return bytes;
}

bool is_complete(std::span<const std::byte> bytes) {
    if (bytes.size() < least_size || std::memcmp(bytes.data(), magic.data(), magic.size()) != 0) return false;
    const std::uint64_t count = number_at(bytes, magic.size() + number_size);
    if ((bytes.size() - least_size) / entry_size != count || (bytes.size() - least_size) % entry_size != 0)
        return false;
    return number_at(bytes, bytes.size() - number_size) ==
           checksum_of_bytes(bytes.first(bytes.size() - number_size));
}

/// Decodes the bytes of a journal; is_complete(bytes) must hold. Returns none if the journal does not match
/// `file`.
std::optional<Journal> decoded(std::span<const std::byte> bytes, const DiskFile& file) {
    Journal journal{.end = number_at(bytes, magic.size()), .blocks = {}};
    if (file.size() < journal.end) return std::nullopt;
    for (std::size_t at = head_size; at + number_size < bytes.size(); at += entry_size) {
        const std::uint64_t number = number_at(bytes, at), before = number_at(bytes, at + number_size);
        const auto block = bytes.subspan(at + 2 * number_size, block_size);
        const std::size_t length = length_of(number, journal.end);
        const std::uint64_t now = stored_checksum(file, number, length);
        if (now != before && now != checksum_of_bytes(block.first(length))) return std::nullopt;
        std::memcpy(journal.blocks[number].data(), block.data(), block_size);
    }
    return journal;
}

/// Returns the content of a file, or no bytes if the file does not exist.
Bytes content_of(const fs::path& file) try {
    const DiskFile opened(file, O_RDONLY);
    Bytes bytes(opened.size());
    opened.read(0, bytes);
    return bytes;
} catch (const Error&) {
    std::error_code not_a_name;  // an error counts as a missing file, for example if the name is too long
    if (fs::exists(file, not_a_name)) throw;
    return {};
}

bool is_applied(const Journal& journal, const DiskFile& file) {
    return std::ranges::all_of(journal.blocks, [&](const auto& entry) {
        const std::size_t length = length_of(entry.first, journal.end);
        return stored_checksum(file, entry.first, length) ==
               checksum_of_bytes(std::span(entry.second).first(length));
    });
}

/// Returns a message on what apply() will change in the file, or "" if nothing.
std::string words_of(const Journal& journal, const DiskFile& file) {
    const std::string left = fmt::format("'{}' was left in the middle of a change, ", file.path().string());
    if (!is_applied(journal, file)) return left + "which is complete now";
    if (file.size() > journal.end)
        return left + fmt::format("of which {} bytes were cut off", file.size() - journal.end);
    return "";
}

std::string improve_locked(const fs::path& file) {
    DiskFile opened(file, O_RDWR);
    if (!opened.lock_exclusive()) return "";
    const Bytes bytes = content_of(journal_of(file));
    std::string done;
    if (is_complete(bytes)) {
        const std::optional<Journal> journal = decoded(bytes, opened);
        if (!journal)
            return fmt::format("'{}' does not fit '{}' in its present state, and is not used; remove it",
                               journal_of(file).string(), file.string());
        done = words_of(*journal, opened);
        apply(*journal, opened);
        opened.sync();
    } else {
        done = fmt::format("'{}' was incomplete, and was removed", journal_of(file).string());
    }
    remove_journal(file);
    return done;
}

}  // namespace

void replace_journal(const DiskFile& file, const Journal& journal) {
    const fs::path target = journal_of(file.path()), temporary = target.string() + ".part";
    try {
        DiskFile part(temporary, O_WRONLY | O_CREAT | O_TRUNC);
        part.write(0, encoded(file, journal));
        part.sync();
    } catch (const Error&) {
        ::unlink(temporary.c_str());
        throw;
    }
    if (std::rename(temporary.c_str(), target.c_str()) != 0)
        throw Error(fmt::format("cannot create '{}': {}", target.string(), std::strerror(errno)), Fault::run);
}

std::optional<Journal> read_journal(const DiskFile& file) {
    const Bytes bytes = content_of(journal_of(file.path()));
    return is_complete(bytes) ? decoded(bytes, file) : std::nullopt;
}

void remove_journal(const fs::path& file) {
    const fs::path journal = journal_of(file);
    ::unlink((journal.string() + ".part").c_str());
    if (::unlink(journal.c_str()) == 0) sync_folder_of(journal);
}

bool has_journal(const fs::path& file) {
    std::error_code none;
    return fs::exists(journal_of(file), none);
}

void apply(const Journal& journal, DiskFile& file) {
    Bytes together;  // content of consecutive blocks, to be written at the offset `first`
    std::uint64_t first = 0;
    for (const auto& [number, block] : journal.blocks) {
        if (number * block_size != first + together.size()) {
            file.write(first, together);
            together.clear();
            first = number * block_size;
        }
        put(together, block.data(), length_of(number, journal.end));
    }
    file.write(first, together);
    if (file.size() > journal.end) file.resize(journal.end);
}

std::string recover(const fs::path& file) {
    if (!has_journal(file)) return "";
    try {
        const OutputLock lock(file);
        return improve_locked(file);
    } catch (const Error&) {
        return "";  // another program writes the file, or the file is read-only
    }
}

}  // namespace sherd
