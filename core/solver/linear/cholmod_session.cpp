// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/solver/linear/cholmod_session.h"

#include <cblas.h>

#include <stdexcept>
#include <string>

// Declared here because OpenMP's header belongs to one compiler's runtime, and CHOLMOD may use another. The
// function exists since OpenMP 3.0.
extern "C" void omp_set_max_active_levels(int levels);

namespace sherd {

CholmodSession::CholmodSession(bool wide) : wide(wide) {
    // CHOLMOD requests a number of OpenMP threads, which slows its supernodal code two to three times on
    // small machines. The only setting that it cannot override is to allow no active parallel region.
    omp_set_max_active_levels(0);
    openblas_set_num_threads(1);
    (wide ? cholmod_l_start : cholmod_start)(&common);
    common.print = 0;
    common.quick_return_if_not_posdef = 1;
    common.nmethods = 1;
}

CholmodSession::~CholmodSession() {
    (wide ? cholmod_l_finish : cholmod_finish)(&common);
}

void CholmodSession::require(bool success, const char* action) const {
    if (success) return;
    const std::string what = std::string("linear solver: cannot ") + action;
    if (common.status == CHOLMOD_OUT_OF_MEMORY)
        throw std::runtime_error(what +
                                 ": there is not enough memory; a coarser mesh or explicit steps need less");
    throw std::runtime_error(what + " (CHOLMOD status " + std::to_string(common.status) + ")");
}

}  // namespace sherd
