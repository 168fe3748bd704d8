// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cholmod.h>

namespace sherd {

/// CHOLMOD's workspace and parameters, for computations in one thread.
class CholmodSession {
  public:
    /// wide: whether indices have 64 bits; CHOLMOD's functions must then be called by their names with
    /// cholmod_l_.
    explicit CholmodSession(bool wide = false);
    ~CholmodSession();
    CholmodSession(const CholmodSession&) = delete;
    /// Throws std::runtime_error, "linear solver: cannot <action>", unless `success`.
    void require(bool success, const char* action) const;

    cholmod_common common;

  private:
    bool wide;
};

}  // namespace sherd
