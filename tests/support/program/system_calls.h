// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace sherd::test {

/// Call by which a program changes files, in a form that can be repeated.
struct SystemCall {
    enum class Kind { write, resize, sync, sync_folder, rename, remove } kind;
    std::filesystem::path file, target = {};  ///< target: the new name, for `rename`
    std::uint64_t offset = 0;                 ///< place of a write, or the size after a resize, bytes
    std::string bytes = {};
};

/// While it exists, notes this process's system calls that change files in a folder, and can let one of them
/// fail. (tests/CMakeLists.txt makes the linker direct the calls here. Only one object may exist at a time.)
class SystemCalls {
  public:
    explicit SystemCalls(std::filesystem::path folder);  ///< folder: the calls on its files are intercepted
    ~SystemCalls();
    SystemCalls(const SystemCalls&) = delete;
    SystemCalls& operator=(const SystemCalls&) = delete;

    /// Notes a call. Returns the error number with which it must fail; 0: the call must be made.
    int note(SystemCall call);

    std::vector<SystemCall> made;
    std::optional<std::size_t> failing;  ///< index of the call that fails; a write writes a part
    int reason = 0;

  private:
    std::filesystem::path folder;
};

}  // namespace sherd::test
