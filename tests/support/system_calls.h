// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace sherd::test {

/// What a program has asked the system to do with files, in a form that can be done once more.
struct SystemCall {
    enum class Kind { write, resize, sync, sync_folder, rename, remove } kind;
    std::filesystem::path file, target = {};  ///< target: the new name
    std::uint64_t offset = 0;                 ///< of what is written; the new size
    std::string bytes = {};
};

/// Listens to this process while it lives, and lets calls fail. (tests/CMakeLists.txt has the linker lead
/// them here; one at a time.)
class SystemCalls {
  public:
    explicit SystemCalls(std::filesystem::path folder);  ///< of which calls are told
    ~SystemCalls();
    SystemCalls(const SystemCalls&) = delete;
    SystemCalls& operator=(const SystemCalls&) = delete;

    /// Notes a call. Returns the error number with which it is to fail; 0: it is to be made.
    int note(SystemCall call);

    std::vector<SystemCall> made;
    std::optional<std::size_t>
        failing;  ///< the number of the call that fails; of a write some sectors are done
    int reason = 0;

  private:
    std::filesystem::path folder;
};

}  // namespace sherd::test
