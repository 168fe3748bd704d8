// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <stdexcept>
#include <string>

namespace sherd {

/// The cause of a failure: bad input (exit code 2) or a run that failed (exit code 1).
enum class Fault { input, run };

/// The only exception type of Sherd. The message says what is wrong, where (file:line, key or element) and
/// what to do about it; main prints it as a line on stderr.
class Error : public std::runtime_error {
  public:
    explicit Error(const std::string& message, Fault fault = Fault::input)
        : std::runtime_error(message), fault(fault) {}

    Fault fault;
};

/// Calls `work` and returns its result. If it throws an Error, `where` and a colon are put in front of the
/// message.
template <class Work>
auto with_context(const std::string& where, const Work& work) {
    try {
        return work();
    } catch (const Error& error) {
        throw Error(where + ": " + error.what(), error.fault);
    }
}

}  // namespace sherd
