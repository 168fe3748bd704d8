// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/recording/hdf5_file.h"

#include <unistd.h>

#include <chrono>

#include "app/files/disk/memory_file.h"
#include "app/recording/hdf5_error.h"
#include "meshops/error.h"

namespace sherd::hdf5 {
namespace {

constexpr auto patience = std::chrono::seconds(10);  // longest wait for a writer's lock

void fill_and_close(ByteFile& bytes, const std::string& name, Access access,
                    const std::function<void(hid_t)>& fill) {
    OpenedFile opened = open_in(bytes, name, access);
    fill(opened.file);
    opened.file.close("'" + name + "'");
}

}  // namespace

ReadableFile::ReadableFile(const std::filesystem::path& file) {
    const std::string name = "'" + file.string() + "'";
    std::error_code reason;
    const std::filesystem::file_status status = std::filesystem::status(file, reason);
    if (status.type() == std::filesystem::file_type::not_found)
        throw Error("there is no file " + name + "; check the path");
    if (reason) throw Error("cannot read " + name + ": " + reason.message() + "; check the path");
    if (!std::filesystem::is_regular_file(status))
        throw Error(name + " is not a file; name a recording (.h5)");
    if (::access(file.c_str(), R_OK) != 0) throw Error("cannot read " + name + "; check its permissions");
    silence_errors();
    if (H5Fis_hdf5(file.c_str()) == 0)
        throw Error(name + " is not an HDF5 file; name a recording written by 'sherd run'");
    bytes = std::make_unique<OverlaidFile>(file, patience);
    try {
        opened = open_in(*bytes, file.string(), Access::read);
    } catch (const Error& error) {
        throw Error(std::string(error.what()) + "; the file is damaged or cut off");
    }
}

void write_new(PendingFile& file, const std::function<void(hid_t)>& fill) {
    MemoryFile bytes;
    fill_and_close(bytes, file.path().string(), Access::create, fill);
    file.write(bytes.text());
}

void change(JournaledFile& file, const std::function<void(hid_t)>& edit) {
    try {
        file.require_undisturbed();
        fill_and_close(file, file.path().string(), Access::write, edit);
    } catch (const Error&) {
        file.roll_back();
        throw;
    }
    file.commit();
}

}  // namespace sherd::hdf5
