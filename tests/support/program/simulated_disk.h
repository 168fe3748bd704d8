// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <random>
#include <string>
#include <vector>

#include "tests/support/program/system_calls.h"

namespace sherd::test {

/// Possible content of a disk after a power cut: all synchronized data, and any part of the rest. Writes may
/// be lost, reordered and torn between sectors. Changes of names are kept in order, up to any one of them, as
/// in file systems with a journal.
class SimulatedDisk {
  public:
    /// Starts with a folder of files that are on the disk.
    explicit SimulatedDisk(const std::map<std::string, std::string>& contents) {
        for (const auto& [file, bytes] : contents) {
            names[file] = now[file] = files.size();
            files.push_back({bytes, {}});
        }
    }

    void make(const SystemCall& call) {
        using Kind = SystemCall::Kind;
        if (call.kind == Kind::write || call.kind == Kind::resize) file_of(call.file).waiting.push_back(call);
        if (call.kind == Kind::sync) {
            File& file = file_of(call.file);
            for (const SystemCall& waiting : file.waiting) change(file.bytes, waiting);
            file.waiting.clear();
        }
        if (call.kind == Kind::rename || call.kind == Kind::remove) change_names(call);
        if (call.kind == Kind::sync_folder) {
            names = now;
            waiting_names.clear();
        }
    }

    /// Replaces the files of `folder` by a possible content of the disk after a power cut. everything: by the
    /// content that it has if only the program ends, and nothing is lost.
    void show(const std::filesystem::path& folder, bool everything, std::mt19937& random) const {
        std::map<std::string, std::size_t> shown = names;
        const std::size_t kept = everything ? waiting_names.size() : random() % (waiting_names.size() + 1);
        if (kept > 0) shown = waiting_names[kept - 1];
        for (const auto& entry : std::filesystem::directory_iterator(folder))
            std::filesystem::remove(entry.path());
        for (const auto& [name, number] : shown)
            std::ofstream(folder / std::filesystem::path(name).filename(), std::ios::binary)
                << (everything ? all_of(files[number]) : some_of(files[number], random));
    }

  private:
    static constexpr std::size_t sector = 512;
    struct File {
        std::string bytes;  ///< content on the disk
        std::vector<SystemCall> waiting;
    };

    File& file_of(const std::filesystem::path& name) {
        if (!now.contains(name.string())) {
            now[name.string()] = files.size();
            files.emplace_back();
            waiting_names.push_back(now);
        }
        return files[now.at(name.string())];
    }

    void change_names(const SystemCall& call) {
        if (!now.contains(call.file.string())) return;
        if (call.kind == SystemCall::Kind::rename) now[call.target.string()] = now.at(call.file.string());
        now.erase(call.file.string());
        waiting_names.push_back(now);
    }

    static void write(std::string& bytes, std::size_t offset, const std::string& what) {
        bytes.resize(std::max(bytes.size(), offset + what.size()));
        bytes.replace(offset, what.size(), what);
    }

    static void change(std::string& bytes, const SystemCall& call) {
        if (call.kind == SystemCall::Kind::resize)
            bytes.resize(call.offset);
        else
            write(bytes, call.offset, call.bytes);
    }

    static std::string all_of(const File& file) {
        std::string bytes = file.bytes;
        for (const SystemCall& call : file.waiting) change(bytes, call);
        return bytes;
    }

    static std::string some_of(const File& file, std::mt19937& random) {
        std::string bytes = file.bytes;
        std::vector<SystemCall> some = file.waiting;
        std::ranges::shuffle(some, random);
        some.resize(random() % (some.size() + 1));
        for (const SystemCall& call : some)
            if (call.kind == SystemCall::Kind::resize)
                bytes.resize(call.offset);
            else
                tear(bytes, call, random() % 4, random);
        return bytes;
    }

    /// Makes a write, but leaves out each of its sectors with probability 1 / left_out; 0: leaves out none.
    static void tear(std::string& bytes, const SystemCall& call, std::size_t left_out, std::mt19937& random) {
        if (random() % 2 == 0) bytes.resize(std::max(bytes.size(), call.offset + call.bytes.size()));
        for (std::size_t at = 0; at < call.bytes.size();) {
            const std::size_t size = std::min(call.bytes.size() - at, sector - (call.offset + at) % sector);
            if (left_out == 0 || random() % left_out != 0)
                write(bytes, call.offset + at, call.bytes.substr(at, size));
            at += size;
        }
    }

    std::vector<File> files;
    std::map<std::string, std::size_t> names,
        now;  ///< indices in `files` by name: on the disk, and as programs see them
    std::vector<std::map<std::string, std::size_t>> waiting_names;
};

}  // namespace sherd::test
