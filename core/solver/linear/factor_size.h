// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/block_matrix.h"

namespace sherd {

/// Number of entries of the factor that cholesky_solver() makes of matrices of this pattern.
double factor_size(const BlockMatrix& matrix);

}  // namespace sherd
