// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/run/checkpoint.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <ostream>

#include "app/files/checksum.h"
#include "app/files/pending_file.h"
#include "app/run/state_archive.h"

namespace sherd {
namespace {

constexpr std::string_view magic = "sherd checkpoint 4\n";

/// End of a file: size (bytes) and checksum of the data between `magic` and it.
struct Seal {
    std::uint64_t size = 0, sum = 0;
};

Checkpoint read_checkpoint(const std::filesystem::path& file) {
    std::string text = text_of(file);
    if (!text.starts_with(magic))
        throw Error(fmt::format("'{}' is not a checkpoint of this version", file.string()));
    Seal seal;
    const std::size_t body_size = text.size() - std::min(text.size(), magic.size() + sizeof seal);
    const std::string_view body = std::string_view(text).substr(magic.size(), body_size);
    if (body_size > 0) std::memcpy(&seal, body.data() + body.size(), sizeof seal);
    if (body_size == 0 || body.size() != seal.size || state_sum(body) != seal.sum)
        throw Error(fmt::format("the checkpoint '{}' is damaged or cut off", file.string()));
    Checkpoint checkpoint;
    StateReader reader(body);
    reader(checkpoint);
    const std::size_t state_size = reader.left().size();
    text.erase(0, text.size() - sizeof seal - state_size);
    text.resize(state_size);
    checkpoint.state = std::move(text);
    return checkpoint;
}

}  // namespace

std::array<std::filesystem::path, 2> checkpoint_files(const std::filesystem::path& recording) {
    return {recording.string() + ".checkpoint-1", recording.string() + ".checkpoint-2"};
}

void remove_checkpoint(const std::filesystem::path& recording, std::int64_t number) {
    std::error_code ignored;
    std::filesystem::remove(checkpoint_files(recording)[number % 2], ignored);
}

void write_checkpoint(const OutputLock& recording, Checkpoint checkpoint,
                      const std::function<void(StateVisitor&)>& visit_all) {
    PendingFile file(checkpoint_files(recording.output())[checkpoint.number % 2], Fault::run, recording);
    file.write([&](std::ostream& out) {
        out << magic;
        StateWriter writer(out);
        writer(checkpoint);
        visit_all(writer);
        const Seal seal{writer.size(), writer.sum()};
        out.write(reinterpret_cast<const char*>(&seal), sizeof seal);
    });
    file.publish_durably();
}

std::optional<Checkpoint> last_checkpoint(const std::filesystem::path& recording,
                                          std::vector<std::string>& warnings) {
    std::optional<Checkpoint> last;
    for (const std::filesystem::path& file : checkpoint_files(recording)) {
        std::error_code ignored;
        std::filesystem::remove(file.string() + ".part", ignored);
        if (!std::filesystem::exists(file)) continue;
        try {
            Checkpoint one = read_checkpoint(file);
            if (!last || one.number > last->number) last = std::move(one);
        } catch (const Error& error) {
            warnings.emplace_back(error.what());
        }
    }
    return last;
}

void remove_checkpoints(const std::filesystem::path& recording) {
    std::error_code ignored;
    for (const std::filesystem::path& file : checkpoint_files(recording)) {
        std::filesystem::remove(file, ignored);
        std::filesystem::remove(file.string() + ".part", ignored);
        // A lock file of a program that was killed while writing: taking the lock removes it.
        if (std::filesystem::exists(file.string() + ".lock", ignored)) try {
                const OutputLock left(file);
            } catch (const Error&) {
                continue;  // another program writes it
            }
    }
}

}  // namespace sherd
