// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/machine/exit_code.h"

#include <sys/wait.h>

namespace sherd {

int exit_code_of(int status) {
    return WIFEXITED(status) ? WEXITSTATUS(status) : signal_base + WTERMSIG(status);
}

}  // namespace sherd
