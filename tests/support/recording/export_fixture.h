// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <cstring>

#include "app/export/export.h"
#include "meshops/error.h"
#include "meshops/read_write/read_mesh.h"
#include "tests/support/program/temporary_directory.h"
#include "tests/support/recording/synthetic_run.h"

namespace sherd::test {

/// Test with a recording of synthetic_run() in a folder of its own.
class Export : public ::testing::Test {
  protected:
    Export() : run(synthetic_run()) { record(run, folder.path / "run.h5"); }

    ExportOptions options(const std::string& format, const std::string& output) const {
        ExportOptions options;
        options.recording = folder.path / "run.h5";
        options.format = format;
        options.output = folder.path / output;
        return options;
    }

    Mesh read(const std::string& name) const {
        std::vector<std::string> warnings;
        Mesh mesh = read_mesh(folder.path / name, {.join_advice = ""}, warnings);
        EXPECT_TRUE(warnings.empty()) << name << ": " << warnings.front();
        return mesh;
    }

    std::string error_of(const ExportOptions& options) const {
        try {
            export_recording(options);
        } catch (const Error& error) {
            EXPECT_EQ(error.fault, Fault::input) << error.what();
            return error.what();
        }
        ADD_FAILURE() << "no error";
        return "";
    }

    std::string bytes(const std::string& name) const { return folder.contents().at(folder.path / name); }

    TemporaryDirectory folder;
    SyntheticRun run;
};

/// Reads numbers out of bytes one after the other, in the byte order of this machine.
class Bytes {
  public:
    explicit Bytes(std::string data, std::size_t place = 0) : data(std::move(data)), place(place) {}

    template <class T>
    T next() {
        T value{};
        if (place + sizeof value > data.size()) throw std::out_of_range("the file ends early");
        std::memcpy(&value, data.data() + place, sizeof value);
        place += sizeof value;
        return value;
    }
    template <class T>
    T next_big_endian() {
        std::reverse(data.begin() + static_cast<long>(place),
                     data.begin() + static_cast<long>(place + sizeof(T)));
        return next<T>();
    }
    std::string text(std::size_t length) {
        place += length;
        return data.substr(place - length, length);
    }
    bool at_end() const { return place == data.size(); }

  private:
    std::string data;
    std::size_t place;
};

}  // namespace sherd::test
