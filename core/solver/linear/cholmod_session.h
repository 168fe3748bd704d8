// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cholmod.h>

namespace sherd {

/// CHOLMOD's workspace and parameters, in one thread.
class CholmodSession {
  public:
    /// wide: indices have 64 bits, and all calls must be those that begin with cholmod_l_.
    explicit CholmodSession(bool wide = false);
    ~CholmodSession();
    CholmodSession(const CholmodSession&) = delete;
    /// Throws std::runtime_error: "linear solver: cannot <action>".
    void require(bool success, const char* action) const;

    cholmod_common common;

  private:
    bool wide;
};

}  // namespace sherd
